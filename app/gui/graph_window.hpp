#pragma once
// The window in which the frame's graph is drawn.

#include "app/gui/graph_boxes.hpp"
#include "app/gui/view_model.hpp"

#include <string>
#include <vector>

namespace atrium::gui {

/// What it remembers between frames.
struct GraphWindow {
    bool open = false;
    vec2 canvas{0};        ///< upper left corner of the part that is drawn into, on the screen
    vec2 origin{0};        ///< of the drawing, from there
    float zoom = 0;        ///< 0: not chosen yet
    std::string pointed;   ///< the box under the mouse, which stays there when the graph changes
    vec2 pointed_at{0};    ///< its corner
    std::string structure; ///< of the graph that is laid out below
    GraphBoxes drawing;
    std::vector<vec2> corners, sizes; ///< of its boxes, at zoom 1
};

/// Draws it where it is open: passes and images as boxes, moved by dragging and scaled by the wheel. A click on an
/// image pins it or no longer, one with the right button shows it in place of the picture or no longer.
/// @param insets  ImGui's name of the image in which the pinned buffers stand side by side
void draw_graph_window(ViewModel& model, const GraphFacts& graph, void* insets, GraphWindow& window, float scale);

} // namespace atrium::gui
