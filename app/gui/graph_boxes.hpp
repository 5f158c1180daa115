#pragma once
// A frame's graph as boxes and lines between them.

#include "renderer/graph_facts.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace atrium::gui {

/// A pass or an image. Passes that follow each other and differ only by a number at the end, such as the levels of a
/// pyramid, are one box.
struct GraphBox {
    std::size_t first_pass = 0, passes = 0;
    std::optional<std::size_t> image; ///< among the resources; else it is of passes
};

/// From who wrote to who reads, by way of the image's box. An image's box is of what its last pass left there: lines to
/// those that read before are from pass to pass, and so are lines of buffers, which have no boxes.
struct GraphLine {
    std::size_t from = 0, to = 0; ///< boxes, from < to
    std::size_t resource = 0;
    bool operator==(const GraphLine&) const = default;
};

struct GraphBoxes {
    std::vector<GraphBox> boxes; ///< passes in order; images behind those that write them
    std::vector<GraphLine> lines;
};

[[nodiscard]] GraphBoxes make_graph_boxes(const GraphFacts& graph);

} // namespace atrium::gui
