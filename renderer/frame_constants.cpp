#include "renderer/frame_constants.hpp"

#include <cmath>

namespace atrium {

shared::FrameConstants make_frame_constants(const FrameRequest& request, const GpuScene& scene)
{
    const Settings& s = request.settings;
    const vec2 size(request.size);
    const float aspect = size.x / size.y;
    const float near = s.camera.near > 0 ? s.camera.near : default_near(scene.bounds());
    const float exposure = exposure_scale(s.exposure);
    const auto clip_from_world = [&](const Camera& c) {
        return clip_from_view(c.fov, aspect, near) * view_from_world(c);
    };
    const mat4 world_axes = glm::transpose(view_from_world(request.camera));

    shared::FrameConstants f{};
    f.clip_from_world = clip_from_world(request.camera);
    f.prev_clip_from_world = clip_from_world(request.previous_camera);
    f.eye = request.camera.eye;
    f.near = near;
    f.right = vec3(world_axes[0]);
    f.up = vec3(world_axes[1]);
    f.forward = -vec3(world_axes[2]);
    f.tan_y = std::tan(glm::radians(0.5f * request.camera.fov));
    f.tan_x = f.tan_y * aspect;
    f.exposure = exposure;
    f.size = size;
    f.inv_size = 1.0f / size;
    f.ambient_sky = s.ambient.sky * (s.ambient.intensity * exposure);
    f.ambient_ground = s.ambient.ground * (s.ambient.intensity * exposure);
    f.sky_zenith = s.sky.zenith * (s.sky.intensity * exposure);
    f.sky_horizon = s.sky.horizon * (s.sky.intensity * exposure);
    f.sky_ground = s.sky.ground * (s.sky.intensity * exposure);
    f.flags = (s.material.normal_mapping ? shared::flag_normal_mapping : 0u) |
              (s.material.specular_mapping ? shared::flag_specular_mapping : 0u) |
              (s.debug.alpha_lod0 ? shared::flag_alpha_lod0 : 0u);
    f.light_count = static_cast<std::uint32_t>(request.lights.size());
    const LightOrder order = order_lights(request.lights);
    for (std::size_t i = 0; i < request.lights.size(); ++i)
        f.lights[order.places[i]] = to_gpu(request.lights[i], exposure);
    const std::vector<std::uint32_t> shadowed = shadowed_lights(request.lights, s.shadow);
    for (std::uint32_t layer = 0; layer < shadowed.size(); ++layer)
        f.lights[order.places[shadowed[layer]]].shadow_layer = layer;
    return f;
}

} // namespace atrium
