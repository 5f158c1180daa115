#pragma once
// Points of lights, for shadows as the mean of many hard ones.

#include "renderer/scene/light.hpp"

#include <cstdint>

namespace atrium {

/// How far a light reaches from its centre, m; sun: tangent of its angular radius.
[[nodiscard]] float light_extent(const Light& light, float softness);

/// The light as it would be, stood it all in its n-th point: moved, or a sun turned. Points are spread evenly however
/// many are taken: over a rectangle, over the sun's disc, and in the ball of a spot or point light so that seen from
/// anywhere they fill its disc evenly. Sources: Roberts 2018, "The Unreasonable Effectiveness of Quasirandom
/// Sequences"; Shirley & Chiu 1997 (square to disc).
[[nodiscard]] Light at_point(const Light& light, float softness, std::uint32_t n);

} // namespace atrium
