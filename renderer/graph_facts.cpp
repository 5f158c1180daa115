#include "renderer/graph_facts.hpp"

#include "renderer/frame.hpp"
#include "renderer/graph/runner.hpp"

namespace atrium {
namespace {

GraphResourceFacts facts_of(const graph::Graph& g, const graph::ResourceDesc& resource, graph::ResourceIndex index)
{
    GraphResourceFacts out;
    out.name = resource.name;
    out.outlives_frame = !resource.transient;
    if (!resource.is_image) {
        out.bytes = g.bytes(graph::Buf{index});
        return out;
    }
    const graph::TexDesc& desc = g.desc(graph::Tex{index});
    out.format = gpu::to_string(desc.format);
    out.size = {desc.width, desc.height};
    out.layers = desc.layers;
    const std::uint64_t texels = std::uint64_t{desc.width} * desc.height * desc.layers;
    out.bytes = resource.size > 0 ? resource.size : texels * gpu::bytes_per_texel(desc.format);
    return out;
}

/// Of two images in one block of memory.
bool overlap(const graph::GraphDesc& desc, const graph::Plan& plan, std::size_t a, std::size_t b)
{
    const graph::Placement &at_a = plan.placements[a], &at_b = plan.placements[b];
    if (at_a.block == graph::Placement{}.block || at_a.block != at_b.block) return false;
    return at_a.offset < at_b.offset + desc.resources[b].size && at_b.offset < at_a.offset + desc.resources[a].size;
}

} // namespace

GraphFacts make_graph_facts(const graph::Graph& g, const Frame& frame, const graph::Runner& runner,
                            const graph::RunStats& stats)
{
    const graph::GraphDesc& desc = runner.planned();
    const graph::Plan& plan = runner.plan();
    GraphFacts out;
    for (std::size_t r = 0; r < desc.resources.size(); ++r) {
        const auto index = static_cast<graph::ResourceIndex>(r);
        out.resources.push_back(facts_of(g, desc.resources[r], index));
        for (std::size_t other = 0; other < desc.resources.size(); ++other) {
            if (other != r && overlap(desc, plan, r, other)) out.resources.back().shares.push_back(other);
        }
    }
    for (const auto& [name, image] : frame.images) out.resources[image.index].can_be_shown = true;
    for (std::size_t p = 0; p < plan.passes.size(); ++p) {
        if (plan.passes[p].pass >= frame.own_passes) break;
        const graph::PassDesc& pass = desc.passes[plan.passes[p].pass];
        out.passes.push_back({pass.name, stats.passes[p].gpu_ms});
        for (const graph::Use& use : pass.uses) {
            const gpu::AccessInfo& access = gpu::info(use.access);
            out.uses.push_back({p, use.resource, access.writes != 0, access.name});
        }
    }
    return out;
}

} // namespace atrium
