#pragma once
// Cameras: where they stand, and the matrices that follow. Reversed, infinite depth.

#include "renderer/core/error.hpp"
#include "renderer/core/math.hpp"
#include "renderer/core/setting.hpp"

#include <string_view>

namespace atrium {

/// Coordinates that users may give, m: beyond it, floats no longer resolve a decimetre.
inline constexpr Range world_range{-1e6f, 1e6f};

/// As users describe it.
struct Camera {
    vec3 eye{0, 1.7f, 5};
    vec3 target{0, 1.7f, 0};
    float fov = 60; ///< vertical, degrees
    bool operator==(const Camera&) const = default;
};

/// Eye and target within world_range and apart, fov between 1 and 170 degrees (both excluded). Throws Error(`code`);
/// `where` is the option or file:line.
void check_camera(const Camera& camera, ExitCode code, std::string_view where);

/// World to view: right-handed, looking down -Z, +Y up; a camera that looks straight up or down takes +Z as its up.
[[nodiscard]] mat4 view_from_world(const Camera& camera);
/// View to clip: z_clip = near, w_clip = -z, so depth = near / distance, 1 at the near plane, 0 at infinity.
/// Clip y points up (drawn with a negative viewport height).
[[nodiscard]] mat4 clip_from_view(float fov_degrees, float aspect, float near);

/// diagonal / 20000, between 1 mm and 0.1 m; for scenes under two centimetres diagonal / 20.
[[nodiscard]] float default_near(const Bounds& bounds);

} // namespace atrium
