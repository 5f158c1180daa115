#include "renderer/techniques/gbuffer/gbuffer.hpp"

#include "renderer/techniques/common/draw_scene.hpp"

namespace atrium {
namespace {

using gpu::Format;
using graph::Load;

GBuffer create_targets(graph::Graph& g, uvec2 size)
{
    const auto target = [&](const char* name, Format format) { return g.texture(name, {format, size.x, size.y}); };
    GBuffer gb;
    gb.albedo = target("gbuffer.albedo", Format::rgba8_srgb);
    gb.normal = target("gbuffer.normal", Format::rg32_uint);
    gb.id = target("gbuffer.id", Format::r32_uint);
    gb.emission = target("gbuffer.emission", Format::r32_uint);
    gb.motion = target("gbuffer.motion", Format::rg16_float);
    gb.depth = target("gbuffer.depth", Format::depth32);
    return gb;
}

} // namespace

graph::PassBuilder& reads(graph::PassBuilder& pass, const GBuffer& gb)
{
    return pass.reads(gb.albedo).reads(gb.normal).reads(gb.id).reads(gb.emission).reads(gb.depth);
}

namespace {

/// State shared by the depth prepass and the G-buffer pass.
gpu::GraphicsPipelineDesc depth_pipeline(const char* vertex)
{
    gpu::GraphicsPipelineDesc desc;
    desc.vertex = vertex;
    desc.depth_test = gpu::DepthTest::greater_equal;
    desc.depth_write = true;
    return desc;
}

/// `loads`: keep where there is something in the targets, or in the depth alone, already.
struct Loads {
    Load colors = Load::discard, depth = Load::clear;
};

void add_pass(graph::Graph& g, const DrawList& draws, const Geometry& geometry, const GBuffer& gb, const Loads& loads,
              const std::string& name)
{
    // Only id and depth are cleared: a background id says that the other targets hold nothing.
    graph::PassBuilder pass = g.raster(name);
    pass.writes(gb.albedo, loads.colors)
        .writes(gb.normal, loads.colors)
        .writes(gb.id, loads.colors == Load::keep ? Load::keep : Load::clear)
        .writes(gb.emission, loads.colors)
        .writes(gb.motion, loads.colors)
        .depth(gb.depth, loads.depth, 0.0f);
    draw_scene(pass, {draws, geometry}, [](const MaterialClassInfo& cls) {
        auto desc = depth_pipeline("techniques/gbuffer/gbuffer.vert");
        desc.fragment = class_fragment("techniques/gbuffer/gbuffer", cls);
        return std::optional(desc);
    });
}

} // namespace

void add_depth_prepass(graph::Graph& g, const DrawList& draws, const Geometry& geometry, graph::Tex depth,
                       const std::string& pass_name)
{
    graph::PassBuilder pass = g.raster(pass_name);
    pass.depth(depth, Load::clear, 0.0f);
    draw_scene(pass, {draws, geometry}, [](const MaterialClassInfo& cls) {
        return cls.has_holes ? std::nullopt : std::optional(depth_pipeline("techniques/gbuffer/depth_prepass.vert"));
    });
}

GBuffer add_gbuffer(graph::Graph& g, const DrawList& draws, const Geometry& geometry, uvec2 size,
                    const std::string& pass_name)
{
    const GBuffer gb = create_targets(g, size);
    add_pass(g, draws, geometry, gb, {}, pass_name);
    return gb;
}

CulledGBuffer add_culled_gbuffer(graph::Graph& g, const DrawTasks& tasks, const Geometry& geometry, uvec2 size,
                                 const CullingSettings& s, bool remember)
{
    if (!s.occlusion) {
        const DrawList draws = add_culling(g, tasks, s);
        return {add_gbuffer(g, draws, geometry, size), {draws}, {}};
    }
    const GBuffer gb = create_targets(g, size);
    if (remember && can_remember(tasks, s)) {
        const SeenInFrame frame = declare_seen(g, tasks);
        add_depth_prepass(g, frame.occluders, geometry, gb.depth);
        add_pass(g, frame.before, geometry, gb, {Load::discard, Load::keep}, "gbuffer");
        const DrawList late = add_culling(g, tasks, s, gb.depth, frame);
        add_pass(g, late, geometry, gb, {Load::keep, Load::keep}, "gbuffer.late");
        return {gb, {frame.before, late}, frame.occluders};
    }
    const DrawList occluders = add_occluders(g, tasks, s);
    add_depth_prepass(g, occluders, geometry, gb.depth);
    const DrawList draws = add_culling(g, tasks, s, gb.depth);
    add_pass(g, draws, geometry, gb, {Load::discard, Load::keep}, "gbuffer");
    return {gb, {draws}, occluders};
}

} // namespace atrium
