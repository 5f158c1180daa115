#include "renderer/techniques/aov/aov.hpp"

#include "renderer/techniques/aov/graph_image.hpp"
#include "renderer/techniques/common/draw_scene.hpp"
#include "shaders/shared/aov.h"

#include <fmt/format.h>

namespace atrium {
namespace {

using gpu::Format;
using graph::Load;

std::string pass_name(const Aov& aov)
{
    return aov.info->per_light ? fmt::format("aov.{}.{}", aov.info->name, aov.light)
                               : fmt::format("aov.{}", aov.info->name);
}

/// Counts the fragments of the G-buffer pass, drawn again in the same order. `tested`: those that reach the shader,
/// after the same occluders, against a depth buffer of its own. Holes of masked materials count as drawn.
graph::Tex add_fragment_count(graph::Graph& g, const AovInputs& in, const std::string& name, bool tested)
{
    graph::TexDesc desc = g.desc(in.gbuffer.depth);
    const graph::Tex depth = tested ? g.texture(name + ".depth", desc) : graph::Tex{};
    desc.format = Format::r32_float;
    const graph::Tex count = g.texture(name, desc);

    const auto counted = [tested](const MaterialClassInfo&) {
        gpu::GraphicsPipelineDesc pipeline;
        pipeline.vertex = "techniques/gbuffer/gbuffer.vert";
        pipeline.fragment = "techniques/aov/overdraw.frag";
        pipeline.depth_test = tested ? gpu::DepthTest::greater_equal : gpu::DepthTest::off;
        pipeline.depth_write = tested;
        pipeline.blend = gpu::Blend::add;
        return std::optional(pipeline);
    };
    const bool prepass = tested && in.occluders.commands;
    if (prepass) add_depth_prepass(g, in.occluders, in.geometry, depth, name + ".prepass");
    bool first = true;
    for (const DrawList& draws : in.draws) {
        graph::PassBuilder pass = g.raster(name);
        if (tested) pass.depth(depth, first && !prepass ? Load::clear : Load::keep, 0.0f);
        pass.writes(count, first ? Load::clear : Load::keep);
        draw_scene(pass, {draws, in.geometry}, counted);
        first = false;
    }
    return count;
}

/// An AOV computed by aov.frag from the G-buffer, and from `image` for the kinds that read it.
graph::Tex add_unpacked(graph::Graph& g, const Aov& aov, const AovInputs& in, graph::Tex image, std::uint32_t kind)
{
    graph::TexDesc desc = g.desc(in.gbuffer.depth);
    const std::uint32_t scale = (desc.width + g.desc(image).width - 1) / g.desc(image).width;
    desc.format = aov.info->channels == 1 ? Format::r32_float : Format::rgba32_float;
    const graph::Tex target = g.texture(pass_name(aov), desc);
    const graph::Tex motion = kind == shared::aov_motion ? in.gbuffer.motion : g.constant(0); // else it is not stored

    graph::PassBuilder pass = g.raster(pass_name(aov));
    reads(pass, in.gbuffer)
        .reads(motion)
        .reads(image)
        .writes(target)
        .fullscreen("techniques/aov/aov.frag", {kind}, shared::AovPush{aov.info->background, scale});
    return target;
}

graph::Tex add_ao_image(graph::Graph& g, const Aov& aov, const AovInputs& in)
{
    if (g.constant_value(in.ao)) return add_unpacked(g, aov, in, g.constant(0), shared::aov_constant);
    return add_unpacked(g, aov, in, aov.info->kind == shared::aov_ao ? in.ao : in.ao_raw, aov.info->kind);
}

graph::Tex add_shadow_image(graph::Graph& g, const Aov& aov, const AovInputs& in)
{
    const graph::Tex image =
        in.shadow_image ? in.shadow_image(g, aov.light, aov.info->kind, pass_name(aov)) : graph::Tex{};
    return image ? image : add_unpacked(g, aov, in, g.constant(0), shared::aov_constant);
}

AovImage add_image_of_graph(graph::Graph& g, const Aov& aov, const AovInputs& in)
{
    if (const auto image = find_graph_image(g, aov, in.images)) {
        const std::string pass = "aov.graph." + graph_image_text(aov);
        return {add_graph_image(g, *image, aov.layer, pass), &graph_image_info(g.desc(*image).format)};
    }
    if (!in.absent_images) refuse_graph_image(g, aov, in.images);
    return {add_unpacked(g, aov, in, g.constant(0), shared::aov_constant), aov.info, true};
}

graph::Tex add_value(graph::Graph& g, const Aov& aov, const AovInputs& in, float exposure)
{
    LightingTerms alone;
    alone.emission = false;
    alone.multi_bounce = in.multi_bounce;
    alone.scale = 1.0f / exposure;
    alone.format = Format::rgba32_float;
    alone.pass = alone.target = pass_name(aov);
    switch (aov.info->source) {
    case AovSource::overdraw:
        return add_fragment_count(g, in, pass_name(aov), true);
    case AovSource::depth_complexity:
        return add_fragment_count(g, in, pass_name(aov), false);
    case AovSource::ambient:
        return add_lighting(g, in.gbuffer, in.ao, g.constant_array(1), alone);
    case AovSource::ao:
        return add_ao_image(g, aov, in);
    case AovSource::shadow:
        return add_shadow_image(g, aov, in);
    case AovSource::light:
        alone.ambient = false;
        alone.first_light = in.lights.places[aov.light];
        alone.end_light = alone.first_light + 1;
        alone.end_delta = alone.first_light < in.lights.delta_count ? alone.end_light : alone.first_light;
        return add_lighting(g, in.gbuffer, g.constant(1), in.visibility, alone);
    case AovSource::hdr:
        return add_unpacked(g, aov, in, in.hdr, aov.info->kind);
    default:
        return add_unpacked(g, aov, in, g.constant(0), aov.info->kind);
    }
}

} // namespace

AovImage add_aov(graph::Graph& g, const Aov& aov, const AovInputs& in, float exposure)
{
    if (aov.info->source == AovSource::graph) return add_image_of_graph(g, aov, in);
    return {add_value(g, aov, in, exposure), aov.info};
}

} // namespace atrium
