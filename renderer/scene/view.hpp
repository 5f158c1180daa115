#pragma once
// The view of a frame: cameras, sizes, exposure and time, and the matrices derived from them once.

#include "renderer/scene/camera.hpp"

#include <cstdint>

namespace atrium {

/// The input from which make_view() derives a View.
struct ViewDescription {
    Camera camera;
    Camera previous_camera; ///< of the previous frame; the same camera if there was none
    uvec2 render_size{1};   ///< pixels that are shaded
    uvec2 output_size{1};   ///< pixels of the picture
    vec2 jitter{0};         ///< offset of everything drawn, in pixels of the render size, x right, y down
    float near = 0.1f;      ///< m
    float exposure = 1;     ///< factor on radiance
    float previous_exposure = 1;
    std::uint64_t frame_index = 0;
    double time = 0;      ///< s
    double time_step = 0; ///< s since the frame before
    /// The previous frame shows something unrelated: nothing of it may be reused.
    bool cut = true;
};

/// A camera's axes in the world, unit length.
struct ViewAxes {
    vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
};
[[nodiscard]] ViewAxes axes_of(const Camera& camera);

/// Tangent of half the vertical field of view.
[[nodiscard]] float half_tangent(const Camera& camera);

/// A camera's matrices, reversed infinite depth (camera.hpp).
struct ViewMatrices {
    mat4 view_from_world{1}, clip_from_view{1}, clip_from_world{1};
};

/// A frame's view. Made only by make_view(), so that derived members always match the description.
struct View : ViewDescription {
    float aspect = 1; ///< of the render size, width / height
    vec2 tangents{1}; ///< of half the fields of view, horizontal and vertical
    ViewAxes axes;
    vec2 clip_jitter{0}; ///< `jitter` in normalised device coordinates, added to every projected position
    /// With the jitter of this frame.
    ViewMatrices now;
    /// Of the previous camera, but with the jitter of this frame: it cancels in the difference of both positions, so
    /// motion vectors contain no jitter.
    ViewMatrices before;
};
[[nodiscard]] View make_view(const ViewDescription& description);

} // namespace atrium
