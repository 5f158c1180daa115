#pragma once
// Cameras for scenes that name none.

#include "renderer/scene/camera.hpp"

#include <cstddef>
#include <span>

namespace atrium {

/// Points of a scene: three floats each, `stride` bytes apart. Those that are not finite do not count.
struct PointSet {
    const std::byte* first = nullptr;
    std::size_t stride = 0, count = 0;
    mat4 world_from_object{1};
};

/// Of the picture's width or height, whichever is reached first, that the projection of what is framed takes up.
inline constexpr float framed_share = 0.85f;

/// Looks down at points from 30 degrees above and 30 aside, from where their projection fills framed_share of the
/// picture and lies in its middle, both ways. Exact in doubles. `aspect`: width / height. A single point is seen from
/// close by; no point at all leaves the camera where cameras begin.
[[nodiscard]] Camera frame_points(std::span<const PointSet> sets, float fov, float aspect);
/// The same of a box.
[[nodiscard]] Camera frame_bounds(const Bounds& bounds, float fov, float aspect);
/// In the middle of a box, at eye height, looking along its longer side.
[[nodiscard]] Camera inside_bounds(const Bounds& bounds, float fov);

} // namespace atrium
