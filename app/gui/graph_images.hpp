#pragma once
// Images of the frame graph as buffers that can be shown.

#include "renderer/graph_facts.hpp"

#include <string>
#include <vector>

namespace atrium::gui {

/// The AOV of an image's layer: "graph.NAME", or "graph.NAME:LAYER" beyond the first.
[[nodiscard]] std::string buffer_of(const GraphResourceFacts& image, std::uint32_t layer = 0);

/// All that a frame's graph had, layer by layer.
[[nodiscard]] std::vector<std::string> buffers_of(const GraphFacts& graph);

} // namespace atrium::gui
