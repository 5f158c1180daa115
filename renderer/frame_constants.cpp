#include "renderer/frame_constants.hpp"

namespace atrium {

ViewDescription describe_view(const FrameRequest& request, const Bounds& scene)
{
    const Settings& s = request.settings;
    ViewDescription v;
    v.camera = request.camera;
    v.previous_camera = request.previous_camera;
    v.render_size = v.output_size = request.size;
    v.jitter = request.jitter;
    v.near = s.camera.near > 0 ? s.camera.near : default_near(scene);
    v.exposure = v.previous_exposure = exposure_scale(s.exposure);
    v.frame_index = request.frame_index;
    v.time = request.time;
    v.time_step = request.time_step;
    v.cut = request.cut;
    return v;
}

shared::FrameConstants make_frame_constants(const View& view, const LightSet& lights, const Settings& s)
{
    const float exposure = view.exposure;
    shared::FrameConstants f{};
    f.clip_from_world = view.now.clip_from_world;
    f.prev_clip_from_world = view.before.clip_from_world;
    f.eye = view.camera.eye;
    f.near = view.near;
    f.right = view.axes.right;
    f.up = view.axes.up;
    f.forward = view.axes.forward;
    f.tan_x = view.tangents.x;
    f.tan_y = view.tangents.y;
    const vec2 shift = view.clip_jitter * view.tangents;
    f.ray_forward = f.forward - shift.x * f.right - shift.y * f.up;
    f.exposure = exposure;
    f.size = vec2(view.render_size);
    f.inv_size = 1.0f / f.size;
    f.jitter = view.clip_jitter;
    f.corner = vec2(-1, 1) - view.clip_jitter;
    f.ambient_sky = s.ambient.sky * (s.ambient.intensity * exposure);
    f.ambient_ground = s.ambient.ground * (s.ambient.intensity * exposure);
    f.sky_zenith = s.sky.zenith * (s.sky.intensity * exposure);
    f.sky_horizon = s.sky.horizon * (s.sky.intensity * exposure);
    f.sky_ground = s.sky.ground * (s.sky.intensity * exposure);
    f.flags = (s.material.normal_mapping ? shared::flag_normal_mapping : 0u) |
              (s.material.specular_mapping ? shared::flag_specular_mapping : 0u) |
              (s.debug.alpha_lod0 ? shared::flag_alpha_lod0 : 0u);
    f.light_count = static_cast<std::uint32_t>(lights.lights.size());
    for (std::size_t i = 0; i < lights.lights.size(); ++i)
        f.lights[lights.places[i]] = to_gpu(lights.lights[i], exposure);
    for (std::uint32_t layer = 0; layer < lights.shadowed.size(); ++layer)
        f.lights[lights.places[lights.shadowed[layer]]].shadow_layer = layer;
    return f;
}

} // namespace atrium
