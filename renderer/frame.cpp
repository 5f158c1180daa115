// The frame on one screen.

#include "renderer/frame.hpp"

namespace atrium {
namespace {

class DeferredRenderer final : public Renderer {
public:
    SceneImages add_passes(graph::Graph& g, const FrameContext& frame) const override
    {
        const Settings& s = frame.settings;
        const auto [gbuffer, draws, occluders] =
            add_culled_gbuffer(g, frame.scene.tasks(), frame.scene.geometry(), frame.size, s.culling, frame.seen);
        const AmbientOcclusion ao = add_ao(g, gbuffer, s.ao);
        LightingTerms all;
        all.ao = ao.result;
        all.multi_bounce = s.ao.multi_bounce;
        all.end_delta = frame.lights.delta_count;
        all.end_light = static_cast<std::uint32_t>(frame.lights.places.size());
        const graph::Tex hdr = add_lighting(g, gbuffer, all);
        add_sky(g, gbuffer.depth, hdr);
        return {{gbuffer, hdr, ao.raw, ao.result, s.ao.multi_bounce, draws, occluders, frame.scene.geometry(),
                 frame.lights},
                hdr};
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

Frame build_frame(graph::Graph& g, const Renderer& renderer, const FrameContext& frame, std::span<const Aov> aovs,
                  std::span<const Light> lights)
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
        const Aov shown = parse_aov(s.debug.view, lights);
        out.picture = add_debug_view(g, add_aov(g, shown, scene.aov_inputs, exposure), *shown.info,
                                     frame.scene.bounds().diagonal());
    }
    return out;
}

} // namespace atrium
