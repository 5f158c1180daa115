#pragma once
// Lines around meshes: the worked example of "Add a pass" in ARCHITECTURE.md.

#include "renderer/techniques/gbuffer/gbuffer.hpp"

namespace atrium {

/// Reads  id, depth, a picture.  Writes  the picture with a line, one pixel wide, along the nearer side of each edge
/// between two meshes. `darkness`: 0 leaves the picture as it is, 1 draws black.
/// Source: Saito & Takahashi 1990, "Comprehensible Rendering of 3-D Shapes".
[[nodiscard]] inline graph::Tex add_outline(graph::Graph& g, const GBuffer& gb, graph::Tex picture,
                                            float darkness = 0.9f)
{
    const graph::Tex outlined = g.texture("outlined", g.desc(picture));
    g.raster("outline").reads(gb.id).reads(gb.depth).reads(picture).writes(outlined).fullscreen("examples/outline.frag",
                                                                                                {}, darkness);
    return outlined;
}

} // namespace atrium
