#pragma once
// The triangles' edges over the picture. README.md beside this file.

#include "renderer/graph/graph.hpp"
#include "renderer/techniques/common/draw_list.hpp"

#include <span>

namespace atrium {

/// Reads  draw commands, depth.  Returns  the picture with the edges over it, in the same image. Pass `wireframe`.
[[nodiscard]] graph::Tex add_wireframe(graph::Graph& g, graph::Tex picture, graph::Tex depth,
                                       std::span<const DrawList> draws, const Geometry& geometry);

} // namespace atrium
