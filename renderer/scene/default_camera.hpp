#pragma once
// Cameras for scenes without cameras.

#include "renderer/scene/camera.hpp"

#include <cstddef>
#include <span>

namespace atrium {

/// Points of a scene: three floats each, `stride` bytes apart. Points that are not finite are ignored.
struct PointSet {
    const std::byte* first = nullptr;
    std::size_t stride = 0, count = 0;
    mat4 world_from_object{1};
};

/// Share of the picture's width or height, whichever is reached first, that the framed points fill.
inline constexpr float framed_share = 0.85f;

/// A camera that looks down at the points from 30 degrees above and 30 degrees to the side, at the distance where their
/// projection is centred and fills framed_share of the picture. Exact in doubles. `aspect`: width / height. A single
/// point is seen from close by; without points the result is the default Camera.
[[nodiscard]] Camera frame_points(std::span<const PointSet> sets, float fov, float aspect);
/// The same for a box.
[[nodiscard]] Camera frame_bounds(const Bounds& bounds, float fov, float aspect);
/// In the middle of a box, at eye height, looking along its longer side.
[[nodiscard]] Camera inside_bounds(const Bounds& bounds, float fov);

} // namespace atrium
