#pragma once
// Between the scene and the pixels of the window, for what is drawn over the picture and dragged there.

#include "renderer/core/math.hpp"
#include "renderer/scene/camera.hpp"

#include <optional>

namespace atrium::gui {

/// A camera's picture on a display of so many pixels, x right and y down.
class Projection {
public:
    Projection(const Camera& camera, vec2 display);

    /// Where a point of the world (m) is seen; nothing where it lies behind the camera or nearly so.
    [[nodiscard]] std::optional<vec2> project(const vec3& point) const;
    /// What lies as far in front of the camera as `point` moves by this much, m, when its image moves by `pixels`.
    [[nodiscard]] vec3 in_view_plane(const vec3& point, vec2 pixels) const;
    /// How wide a pixel is there, m.
    [[nodiscard]] float pixel_size(const vec3& point) const;

    vec3 eye;                ///< m
    vec3 right, up, forward; ///< the camera's unit axes in the world

private:
    [[nodiscard]] float depth(const vec3& point) const;

    vec2 middle_;
    float focal_; ///< pixels: of something as wide as it is far
};

} // namespace atrium::gui
