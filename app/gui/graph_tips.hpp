#pragma once
// What is said of passes and images of the frame's graph.

#include "app/gui/graph_boxes.hpp"

#include <string>

namespace atrium::gui {

/// "gbuffer", "depth_pyramid.0 to 2", "hdr".
[[nodiscard]] std::string title_of(const GraphFacts& graph, const GraphBox& box);
/// What the passes took, or the image's format, size and memory.
[[nodiscard]] std::string subtitle_of(const GraphFacts& graph, const GraphBox& box);
/// Of the box's passes.
[[nodiscard]] double gpu_ms(const GraphFacts& graph, const GraphBox& box);
/// How much there is of everything.
[[nodiscard]] std::string summary_of(const GraphFacts& graph);

/// A tooltip: who does what with the image, or what the passes do with which; size, memory and with whom it is shared.
void draw_graph_tip(const GraphFacts& graph, const GraphBox& box);

} // namespace atrium::gui
