#pragma once
// What a frame is looked at with: cameras, sizes, exposure and time, and the matrices that follow, derived once.

#include "renderer/scene/camera.hpp"

#include <cstdint>

namespace atrium {

/// What is known of a frame's view before anything is derived.
struct ViewDescription {
    Camera camera;
    Camera previous_camera; ///< of the frame before; where there was none, the same
    uvec2 render_size{1};   ///< pixels that are shaded
    uvec2 output_size{1};   ///< pixels of the picture
    vec2 jitter{0};         ///< pixels of the render size, x right, y down: everything is drawn so far away
    float near = 0.1f;      ///< m
    float exposure = 1;     ///< factor on radiance
    float previous_exposure = 1;
    std::uint64_t frame_index = 0;
    double time = 0;      ///< s
    double time_step = 0; ///< s since the frame before
    /// This frame does not go on from the one before: nothing of it may be reused.
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

/// A frame's view. Made by make_view() alone, so that what is derived fits what it is derived from.
struct View : ViewDescription {
    float aspect = 1; ///< of the render size, width / height
    vec2 tangents{1}; ///< of half the fields of view, horizontal and vertical
    ViewAxes axes;
    vec2 clip_jitter{0}; ///< `jitter` in normalised device coordinates: added to those of every position
    /// With the jitter of this frame.
    ViewMatrices now;
    /// Of the camera before, with the jitter of this frame too: it drops out of the difference of positions in both, so
    /// motion vectors hold none.
    ViewMatrices before;
};
[[nodiscard]] View make_view(const ViewDescription& description);

} // namespace atrium
