#include "renderer/techniques/common/draw_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace atrium {
namespace {

/// One multi-draw: a range with its pipeline, by index in the pass.
struct RangeDraw {
    DrawRange range;
    std::size_t pipeline = 0;
};

void bind_geometry(graph::Cmd& cmd, const Geometry& geometry, const DrawList& list)
{
    if (list.indices) {
        cmd.bind_geometry(*geometry.vertices, list.indices);
    } else {
        cmd.bind_geometry(*geometry.vertices, *geometry.indices);
    }
}

/// Declares the pipelines, each once, and assigns them to the ranges that are drawn.
std::vector<RangeDraw> declare_pipelines(graph::PassBuilder& pass, const SceneDraws& draws,
                                         const ClassPipeline& pipeline_of)
{
    std::vector<gpu::GraphicsPipelineDesc> pipelines;
    std::vector<RangeDraw> out;
    for (const DrawRange& range : draws.list.ranges) {
        if (!out.empty() && out.back().range.cls == range.cls) { // same class, other sidedness
            out.push_back({range, out.back().pipeline});
            continue;
        }
        const MaterialClassInfo& cls = class_info(range.cls);
        const std::optional<gpu::GraphicsPipelineDesc> own = pipeline_of(cls);
        if (!own) continue;
        const gpu::GraphicsPipelineDesc desc = class_pipeline(*own, cls, draws.geometry);
        const auto known = std::find(pipelines.begin(), pipelines.end(), desc);
        out.push_back({range, static_cast<std::size_t>(known - pipelines.begin())});
        if (known == pipelines.end()) pipelines.push_back(desc);
    }
    for (gpu::GraphicsPipelineDesc& desc : pipelines) pass.pipeline(std::move(desc));
    return out;
}

} // namespace

void draw_scene(graph::PassBuilder& pass, const SceneDraws& draws, const ClassPipeline& pipeline_of)
{
    pass.reads(draws.list.commands, gpu::Access::indirect_read);
    if (draws.list.indices) pass.reads(draws.list.indices, gpu::Access::index_read);
    pass.record([draws, ranges = declare_pipelines(pass, draws, pipeline_of)](graph::Cmd& cmd) {
        bind_geometry(cmd, draws.geometry, draws.list);
        std::optional<std::size_t> bound;
        for (std::uint32_t view = 0; view < draws.views; ++view) {
            if (draws.begin_view) draws.begin_view(cmd, view);
            for (const auto& [range, pipeline] : ranges) {
                if (bound != pipeline) cmd.bind(pipeline);
                bound = pipeline;
                const bool all_faces = draws.both_sides || range.two_sided;
                cmd.cull(all_faces ? graph::CullMode::none : graph::CullMode::back);
                cmd.draw_indexed_indirect(draws.list.commands, view * draws.list.count + range.first, range.count);
            }
        }
    });
}

gpu::GraphicsPipelineDesc class_pipeline(gpu::GraphicsPipelineDesc desc, const MaterialClassInfo& cls,
                                         const Geometry& geometry)
{
    const bool tessellates = !desc.tessellation_evaluation.empty();
    if (cls.tessellated && !tessellates) {
        throw std::logic_error(fmt::format("{} draws the tessellated class {} without tessellation stages", desc.vertex,
                                           to_string(cls.cls)));
    }
    desc.input = gpu::VertexInput::scene;
    const auto own = {geometry.materials_diverge ? 1u : 0u, static_cast<std::uint32_t>(cls.vertex)};
    desc.constants.insert(desc.constants.begin(), own.begin(), own.end());
    if (tessellates) {
        desc.topology = gpu::Topology::patches;
        desc.patch_points = 3;
    }
    return desc;
}

} // namespace atrium
