#pragma once
// What is around the scene: the sky, and the floor below it.

#include "renderer/frame.hpp"

namespace atrium {

/// Returns `radiance` with what is seen where there is no geometry. The floor, where `sky.floor` is on and the camera
/// above it, takes the shadows of `maps` and is darkened near what stands on it, by passes of its own: `sky.floor`,
/// `sky.visibility.L`, `sky.ao`. A floor that is `auto` is left to the program, and off here.
[[nodiscard]] graph::Tex add_surroundings(graph::Graph& g, const FrameContext& frame, const GBuffer& gbuffer,
                                          const ShadowMapSet& maps, graph::Tex radiance);

} // namespace atrium
