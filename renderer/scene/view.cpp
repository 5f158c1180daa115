#include "renderer/scene/view.hpp"

#include <cmath>

namespace atrium {
namespace {

ViewMatrices matrices(const Camera& camera, float aspect, float near, const vec2& clip_jitter)
{
    ViewMatrices m;
    m.view_from_world = view_from_world(camera);
    m.clip_from_view = clip_from_view(camera.fov, aspect, near);
    // w is -z: an offset of x and y that is proportional to w is constant over the picture.
    m.clip_from_view[2][0] -= clip_jitter.x;
    m.clip_from_view[2][1] -= clip_jitter.y;
    m.clip_from_world = m.clip_from_view * m.view_from_world;
    return m;
}

} // namespace

ViewAxes axes_of(const Camera& camera)
{
    const mat4 world_axes = glm::transpose(view_from_world(camera));
    return {vec3(world_axes[0]), vec3(world_axes[1]), -vec3(world_axes[2])};
}

float half_tangent(const Camera& camera)
{
    return std::tan(glm::radians(0.5f * camera.fov));
}

View make_view(const ViewDescription& description)
{
    View v{description};
    const vec2 size(v.render_size);
    v.aspect = size.x / size.y;
    v.tangents.y = half_tangent(v.camera);
    v.tangents.x = v.tangents.y * v.aspect;
    v.axes = axes_of(v.camera);
    v.clip_jitter = vec2(2, -2) * v.jitter / size + vec2(0); // turns -0 into +0
    v.now = matrices(v.camera, v.aspect, v.near, v.clip_jitter);
    v.before = matrices(v.previous_camera, v.aspect, v.near, v.clip_jitter);
    return v;
}

} // namespace atrium
