// The frame on one screen.

#include "renderer/frame.hpp"

#include "renderer/techniques/wireframe/wireframe.hpp"

namespace atrium {
namespace {

struct FrameShadows {
    ShadowMapSet maps;
    graph::Tex visibility;
};

FrameShadows add_shadows(graph::Graph& g, const GBuffer& gbuffer, const FrameContext& frame)
{
    if (!frame.shadow_maps) return {};
    const Settings& s = frame.settings;
    const float aspect = static_cast<float>(frame.size.x) / static_cast<float>(frame.size.y);
    const ShadowCasters casters{frame.scene.tasks(), frame.scene.geometry(), frame.scene.bounds(),
                                vec2(s.texture.anisotropy, s.debug.alpha_lod0 ? 1 : 0)};
    const ShadowMapSet maps = frame.shadow_maps->add(g, casters, frame.lights, frame.camera, aspect, s.shadow);
    if (s.shadow.filter != ShadowFilter::reference)
        return {maps, add_all_visibility(g, gbuffer, maps, frame.lights, s.shadow)};
    return {maps,
            frame.shadow_maps->add_reference(g, gbuffer, casters, frame.lights, frame.camera, aspect, maps, s.shadow)};
}

class DeferredRenderer final : public Renderer {
public:
    SceneImages add_passes(graph::Graph& g, const FrameContext& frame) const override
    {
        const Settings& s = frame.settings;
        const auto [gbuffer, draws, occluders] =
            add_culled_gbuffer(g, frame.scene.tasks(), frame.scene.geometry(), frame.size, s.culling, frame.seen);
        const AmbientOcclusion ao = add_ao(g, gbuffer, s.ao);
        const auto [shadows, visibility] = add_shadows(g, gbuffer, frame);
        LightingTerms all;
        all.visibility = visibility;
        all.ao = ao.result;
        all.multi_bounce = s.ao.multi_bounce;
        all.end_delta = frame.light_order.delta_count;
        all.end_light = static_cast<std::uint32_t>(frame.light_order.places.size());
        const graph::Tex hdr = add_lighting(g, gbuffer, all);
        add_sky(g, gbuffer.depth, hdr);
        AovInputs inputs{gbuffer,           hdr,   ao.raw,    ao.result,
                         s.ao.multi_bounce, draws, occluders, frame.scene.geometry(),
                         frame.light_order};
        inputs.visibility = visibility;
        inputs.shadow_image = [gbuffer = gbuffer, shadows = shadows, visibility = visibility, lights = frame.lights,
                               settings = s.shadow](graph::Graph& graph, std::uint32_t light, std::uint32_t shown,
                                                    const std::string& pass) {
            return add_shadow_image(graph, gbuffer, shadows, lights, visibility, settings, light, shown, pass);
        };
        return {inputs, hdr};
    }
};

} // namespace

std::unique_ptr<Renderer> make_renderer(RenderPath path)
{
    switch (path) {
    case RenderPath::deferred:
        return std::make_unique<DeferredRenderer>();
    }
    return nullptr;
}

Frame build_frame(graph::Graph& g, const Renderer& renderer, const FrameContext& frame, std::span<const Aov> aovs)
{
    const Settings& s = frame.settings;
    const float exposure = exposure_scale(s.exposure);
    const SceneImages scene = renderer.add_passes(g, frame);

    Frame out;
    out.hdr = scene.hdr;
    out.draws = scene.aov_inputs.draws;
    for (const Aov& aov : aovs) out.aovs.push_back(add_aov(g, aov, scene.aov_inputs, exposure));
    if (s.debug.view.empty()) {
        out.picture = add_tonemap(g, scene.hdr, s.tonemap);
    } else {
        const Aov shown = parse_aov(s.debug.view, frame.lights);
        out.picture = add_debug_view(g, add_aov(g, shown, scene.aov_inputs, exposure), *shown.info, frame.size,
                                     frame.scene.bounds().diagonal());
    }
    if (s.debug.wireframe && frame.can_draw_lines)
        add_wireframe(g, out.picture, scene.aov_inputs.gbuffer.depth, out.draws, frame.scene.geometry());
    return out;
}

} // namespace atrium
