// The frame on one screen.

#include "renderer/frame.hpp"

#include "renderer/surroundings.hpp"
#include "renderer/techniques/material_outline/material_outline.hpp"
#include "renderer/techniques/wireframe/wireframe.hpp"

#include <fmt/format.h>

#include <utility>

namespace atrium {
namespace {

struct FrameShadows {
    ShadowMapSet maps;
    graph::Tex visibility;
};

FrameShadows add_shadows(graph::Graph& g, graph::Tex depth, graph::Tex normal, const FrameContext& frame)
{
    if (!frame.shadow_maps) return {{}, g.constant_array(1)};
    const Settings& s = frame.settings;
    const ShadowCasters casters{frame.scene.tasks(), frame.scene.geometry(), frame.scene.bounds(),
                                vec2(s.texture.anisotropy, s.debug.alpha_lod0 ? 1 : 0)};
    const ShadowMapSet maps = frame.shadow_maps->add(g, casters, frame.lights, frame.view, s.shadow);
    if (s.shadow.filter != ShadowFilter::reference)
        return {maps, add_all_visibility(g, depth, normal, maps, frame.lights.lights, s.shadow)};
    return {maps,
            frame.shadow_maps->add_reference(g, depth, normal, casters, frame.lights, frame.view, maps, s.shadow)};
}

class DeferredRenderer final : public Renderer {
public:
    SceneImages add_passes(graph::Graph& g, const FrameContext& frame) const override
    {
        const Settings& s = frame.settings;
        const auto [gbuffer, draws, occluders] = add_culled_gbuffer(g, frame.scene.tasks(), frame.scene.geometry(),
                                                                    frame.view.render_size, s.culling, frame.remember);
        const AmbientOcclusion ao = add_ao(g, gbuffer.depth, gbuffer.normal, frame.view, s.ao);
        const auto [shadows, visibility] = add_shadows(g, gbuffer.depth, gbuffer.normal, frame);
        LightingTerms all;
        all.multi_bounce = s.ao.multi_bounce;
        all.end_delta = frame.lights.delta_count;
        all.end_light = static_cast<std::uint32_t>(frame.lights.lights.size());
        const graph::Tex lit = add_lighting(g, gbuffer, ao.result, visibility, all);
        const graph::Tex hdr = add_surroundings(g, frame, gbuffer, shadows, lit);
        AovInputs inputs{
            gbuffer, hdr, ao.raw, ao.result, s.ao.multi_bounce, draws, occluders, frame.scene.geometry(), frame.lights};
        inputs.visibility = visibility;
        inputs.shadow_image = [depth = gbuffer.depth, normal = gbuffer.normal, shadows = shadows,
                               visibility = visibility, lights = frame.lights.lights,
                               settings = s.shadow](graph::Graph& graph, std::uint32_t light, std::uint32_t shown,
                                                    const std::string& pass) {
            return add_shadow_image(graph, depth, normal, shadows, lights, visibility, settings, light, shown, pass);
        };
        return {inputs, hdr};
    }
};

BufferLook look_of(const AovInfo& info, float scene_size)
{
    if (info.low != info.high || info.source == AovSource::graph)
        return {info.channels, info.view_mode, info.low, info.high};
    return info.channels == 3 ? BufferLook{info.channels, info.view_mode, -0.5f * scene_size, 0.5f * scene_size}
                              : BufferLook{info.channels, info.view_mode, 0, scene_size};
}

/// Shows an AOV in an area of `picture`, which is replaced by the new handle.
ShownBuffer show_buffer(graph::Graph& g, const Inset& buffer, const SceneImages& scene, const FrameContext& frame,
                        graph::Tex& picture, const PictureArea& area, graph::Load load, const std::string& pass)
{
    const AovImage image = add_aov(g, buffer.aov, scene.aov_inputs, frame.view.exposure);
    const BufferLook look = look_of(*image.info, frame.scene.bounds().diagonal());
    const graph::Buf statistics = add_buffer_statistics(g, image.values, look, buffer.view, pass);
    picture = add_buffer_view(g, image.values, statistics, look, buffer.view, picture, area, load, pass);
    return {image.values, statistics, look.channels, choose_view(look, buffer.view).mode, image.absent};
}

void add_insets(graph::Graph& g, const SceneImages& scene, const FrameContext& frame, Frame& out)
{
    if (!frame.insets || frame.insets->buffers.empty()) return;
    const uvec2 size = frame.insets->size;
    const auto count = static_cast<std::uint32_t>(frame.insets->buffers.size());
    out.insets = g.texture("insets", {gpu::Format::rgba8_srgb, count * size.x, size.y});
    for (std::uint32_t i = 0; i < count; ++i) {
        out.shown.push_back(show_buffer(g, frame.insets->buffers[i], scene, frame, out.insets, {{i * size.x, 0}, size},
                                        i == 0 ? graph::Load::clear : graph::Load::keep, fmt::format("inset.{}", i)));
    }
}

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
    SceneImages scene = renderer.add_passes(g, frame);

    Frame out;
    out.picture = add_tonemap(g, scene.hdr, s.tonemap); // dropped where a buffer takes its place
    out.own_passes = g.pass_count();
    scene.aov_inputs.images = g.readable_images();
    scene.aov_inputs.absent_images = frame.absent_images;
    out.hdr = scene.hdr;
    out.draws = scene.aov_inputs.draws;
    for (const Aov& aov : aovs) out.aovs.push_back(add_aov(g, aov, scene.aov_inputs, frame.view.exposure));
    if (!s.debug.view.empty()) {
        const uvec2 size = frame.view.output_size;
        out.picture = g.texture("buffer_view", {gpu::Format::rgba8_srgb, size.x, size.y});
        const Inset whole{parse_aov(s.debug.view, frame.lights.lights), s.buffer_view};
        out.shown.push_back(
            show_buffer(g, whole, scene, frame, out.picture, {uvec2(0), size}, graph::Load::discard, "buffer_view"));
    }
    add_insets(g, scene, frame, out);
    if (s.debug.wireframe && frame.can_draw_lines)
        out.picture = add_wireframe(g, out.picture, scene.aov_inputs.gbuffer.depth, out.draws, frame.scene.geometry());
    if (frame.outlined)
        out.picture = add_material_outline(g, scene.aov_inputs.gbuffer.id, out.picture, *frame.outlined);
    out.images = std::move(scene.aov_inputs.images);
    return out;
}

} // namespace atrium
