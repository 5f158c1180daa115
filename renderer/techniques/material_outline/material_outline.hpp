#pragma once
// A line around the pixels of one material. README.md beside this file.

#include "renderer/graph/graph.hpp"

#include <cstdint>

namespace atrium {

/// Reads  the G-buffer's id.  Returns  the picture with the line over it, within the material's own pixels, in the same
/// image. Pass `material_outline`.
[[nodiscard]] graph::Tex add_material_outline(graph::Graph& g, graph::Tex id, graph::Tex picture,
                                              std::uint32_t material);

} // namespace atrium
