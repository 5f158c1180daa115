#include "renderer/surroundings.hpp"

#include <algorithm>

namespace atrium {
namespace {

constexpr float contact_radius = 0.1f; ///< of the scene's diagonal: radius of the floor's ambient occlusion
constexpr int contact_samples = 8;

FloorSurface add_visible_floor(graph::Graph& g, const FrameContext& frame, graph::Tex depth)
{
    const Bounds& scene = frame.scene.bounds();
    if (frame.settings.sky.floor != SkyFloor::on || scene.empty()) return {};
    const FloorPlace place = floor_below(scene);
    return frame.view.camera.eye.y > place.middle.y ? add_floor(g, depth, place) : FloorSurface{};
}

} // namespace

graph::Tex add_surroundings(graph::Graph& g, const FrameContext& frame, const GBuffer& gbuffer,
                            const ShadowMapSet& maps, graph::Tex radiance)
{
    const FloorSurface floor = add_visible_floor(g, frame, gbuffer.depth);
    if (!floor) return add_sky(g, gbuffer.depth, radiance);
    const std::string prefix = "sky.";
    FloorLight light;
    ShadowSettings shadow = frame.settings.shadow;
    if (shadow.filter == ShadowFilter::reference) shadow.filter = ShadowFilter::pcss; // one map, not hundreds
    light.visibility =
        add_all_visibility(g, floor.visible_depth, floor.normal, maps, frame.lights.lights, shadow, {prefix, true});
    AoSettings ao = frame.settings.ao;
    ao.radius = contact_radius * frame.scene.bounds().diagonal();
    ao.samples = std::min(ao.samples, contact_samples);
    ao.half_resolution = true; // it has no detail of its own
    light.ao = add_ao(g, floor.whole_depth, floor.normal, frame.view, ao, prefix).result;
    light.rects = std::any_of(frame.lights.lights.begin(), frame.lights.lights.end(),
                              [](const Light& l) { return l.type == LightType::rect; });
    return add_sky_and_floor(g, gbuffer.depth, radiance, floor, light);
}

} // namespace atrium
