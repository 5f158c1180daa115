#pragma once
// A line around the pixels of one material. README.md beside this file.

#include "renderer/graph/graph.hpp"

#include <cstdint>

namespace atrium {

/// Reads  the G-buffer's id.  Writes  over the picture, within the material's own pixels. Pass `material_outline`.
void add_material_outline(graph::Graph& g, graph::Tex id, graph::Tex picture, std::uint32_t material);

} // namespace atrium
