#include "app/gui/graph_images.hpp"

#include <fmt/format.h>

namespace atrium::gui {

std::string buffer_of(const GraphResourceFacts& image, std::uint32_t layer)
{
    return layer == 0 ? "graph." + image.name : fmt::format("graph.{}:{}", image.name, layer);
}

std::vector<std::string> buffers_of(const GraphFacts& graph)
{
    std::vector<std::string> out;
    for (const GraphResourceFacts& r : graph.resources) {
        for (std::uint32_t layer = 0; r.can_be_shown && layer < r.layers; ++layer) out.push_back(buffer_of(r, layer));
    }
    return out;
}

} // namespace atrium::gui
