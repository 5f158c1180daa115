#include "renderer/techniques/gbuffer/gbuffer.hpp"

#include "renderer/materials/material_class.hpp"

namespace atrium {
namespace {

using gpu::Format;
using graph::Load;

const MaterialClassInfo& info_of(MaterialClass cls)
{
    return material_classes[static_cast<std::size_t>(draw_rank(cls))];
}

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
    return pass.reads(gb.albedo).reads(gb.normal).reads(gb.id).reads(gb.emission).reads(gb.motion).reads(gb.depth);
}

graph::PassBuilder& reads(graph::PassBuilder& pass, const DrawList& draws)
{
    pass.reads(draws.commands, gpu::Access::indirect_read);
    if (draws.indices) pass.reads(draws.indices, gpu::Access::index_read);
    return pass;
}

void bind_geometry(graph::Cmd& cmd, const Geometry& geometry, const DrawList& draws)
{
    if (draws.indices) {
        cmd.bind_geometry(*geometry.vertices, draws.indices);
    } else {
        cmd.bind_geometry(*geometry.vertices, *geometry.indices);
    }
}

void scene_pipelines(graph::PassBuilder& pass, std::span<const DrawRange> ranges, const std::string& shaders,
                     const gpu::GraphicsPipelineDesc& state)
{
    const DrawRange* previous = nullptr;
    for (const DrawRange& range : ranges) {
        if (!previous || previous->cls != range.cls) {
            gpu::GraphicsPipelineDesc desc = state;
            desc.input = gpu::VertexInput::scene;
            desc.fragment = class_fragment(shaders, info_of(range.cls));
            pass.pipeline(std::move(desc));
        }
        previous = &range;
    }
}

void draw_ranges(graph::Cmd& cmd, std::span<const DrawRange> ranges,
                 const std::function<void(std::uint32_t, std::uint32_t)>& draw)
{
    const DrawRange* previous = nullptr;
    std::size_t pipeline = 0;
    for (const DrawRange& range : ranges) {
        if (!previous || previous->cls != range.cls) cmd.bind(pipeline++);
        cmd.cull(range.two_sided ? graph::CullMode::none : graph::CullMode::back);
        draw(range.first, range.count);
        previous = &range;
    }
}

void add_depth_prepass(graph::Graph& g, const DrawList& draws, const Geometry& geometry, graph::Tex depth,
                       const std::string& pass_name)
{
    gpu::GraphicsPipelineDesc state;
    state.vertex = "techniques/gbuffer/depth_prepass.vert";
    state.input = gpu::VertexInput::scene;
    state.depth_test = gpu::DepthTest::greater_equal;
    state.depth_write = true;
    graph::PassBuilder pass = g.raster(pass_name);
    reads(pass, draws).depth(depth, Load::clear, 0.0f).pipeline(state).record([=](graph::Cmd& cmd) {
        cmd.bind();
        bind_geometry(cmd, geometry, draws);
        for (const DrawRange& range : draws.ranges) {
            if (info_of(range.cls).has_holes) continue;
            cmd.cull(range.two_sided ? graph::CullMode::none : graph::CullMode::back);
            cmd.draw_indexed_indirect(draws.commands, range.first, range.count);
        }
    });
}

namespace {

/// `loads`: keep where there is something in the targets, or in the depth alone, already.
struct Loads {
    Load colors = Load::discard, depth = Load::clear;
};

void add_pass(graph::Graph& g, const DrawList& draws, const Geometry& geometry, const GBuffer& gb, const Loads& loads,
              const std::string& name)
{
    gpu::GraphicsPipelineDesc state;
    state.vertex = "techniques/gbuffer/gbuffer.vert";
    state.depth_test = gpu::DepthTest::greater_equal;
    state.depth_write = true;
    state.constants = {geometry.materials_diverge ? 1u : 0u};

    // Only id and depth are cleared: a background id says that the other targets hold nothing.
    graph::PassBuilder pass = g.raster(name);
    reads(pass, draws)
        .writes(gb.albedo, loads.colors)
        .writes(gb.normal, loads.colors)
        .writes(gb.id, loads.colors == Load::keep ? Load::keep : Load::clear)
        .writes(gb.emission, loads.colors)
        .writes(gb.motion, loads.colors)
        .depth(gb.depth, loads.depth, 0.0f);
    scene_pipelines(pass, draws.ranges, "techniques/gbuffer/gbuffer", state);
    pass.record([=](graph::Cmd& cmd) {
        bind_geometry(cmd, geometry, draws);
        draw_ranges(cmd, draws.ranges, [&](std::uint32_t first, std::uint32_t count) {
            cmd.draw_indexed_indirect(draws.commands, first, count);
        });
    });
}

} // namespace

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
