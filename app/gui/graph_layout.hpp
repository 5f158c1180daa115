#pragma once
// Where the boxes of a drawn graph stand.

#include "renderer/core/math.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace atrium::gui {

struct GraphEdge {
    std::size_t from = 0, to = 0;
};

/// Upper left corner of each box, from (0, 0). Boxes stand in columns, one below the other, so that every edge goes to
/// a column farther right; within a column near those that they are joined with, so that few edges cross. The same
/// graph is always laid out in the same way.
/// @param sizes  of the boxes, in an order in which every edge goes forward
/// @param gaps   between columns, and between boxes of a column
/// Source: Sugiyama, Tagawa, Toda 1981, "Methods for Visual Understanding of Hierarchical System Structures".
[[nodiscard]] std::vector<vec2> lay_out_graph(std::span<const vec2> sizes, std::span<const GraphEdge> edges,
                                              const vec2& gaps);

} // namespace atrium::gui
