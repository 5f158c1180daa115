#pragma once
// What is around the scene: the sky, and the floor below it.

#include "renderer/frame.hpp"

namespace atrium {

/// Returns `radiance` with sky and floor where there is no geometry. If `sky.floor` is on and the camera is above the
/// floor, the floor receives the shadows in `maps` and ambient occlusion, by passes of its own: `sky.floor`,
/// `sky.visibility.L`, `sky.ao`. `auto` counts as off here: the program decides it before.
[[nodiscard]] graph::Tex add_surroundings(graph::Graph& g, const FrameContext& frame, const GBuffer& gbuffer,
                                          const ShadowMapSet& maps, graph::Tex radiance);

} // namespace atrium
