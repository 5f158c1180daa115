#include "renderer/graph/plan.hpp"

#include "renderer/graph/plan_state.hpp"

#include <algorithm>

namespace atrium::graph {
namespace {

using namespace detail;

/// PlannedPass::unstored, given what is wanted after the pass.
std::uint64_t find_unstored(const GraphDesc& graph, const PassDesc& pass, const std::vector<std::vector<bool>>& wanted)
{
    std::uint64_t out = 0;
    for (std::size_t u = 0; u < std::min<std::size_t>(pass.uses.size(), 64); ++u) {
        const Use& use = pass.uses[u];
        if (use.access != Access::color_write && use.access != Access::depth_write) continue;
        bool any = false;
        each_part(graph.resources[use.resource], use.range, [&](std::size_t s) { any |= wanted[use.resource][s]; });
        if (!any) out |= std::uint64_t{1} << u;
    }
    return out;
}

/// Divides the passes into those that run and those whose outputs nobody uses. Looks back from the end of the frame,
/// keeping for every subresource whether its present contents are still wanted.
void choose_passes(const GraphDesc& graph, const std::vector<PassDemands>& demands, const PassDemands& finals,
                   Plan& plan)
{
    std::vector<std::vector<bool>> wanted;
    for (const ResourceDesc& r : graph.resources) wanted.emplace_back(subresource_count(r), r.keep);
    for (const ResourceDemand& d : finals) wanted[d.resource].assign(wanted[d.resource].size(), true);

    const auto each = [](const PassDemands& pass, auto&& function) {
        for (const ResourceDemand& d : pass) {
            for (std::size_t s = 0; s < d.subresources.size(); ++s) {
                if (d.subresources[s].used()) function(d.resource, s, d.subresources[s]);
            }
        }
    };
    for (std::size_t p = graph.passes.size(); p-- > 0;) {
        bool runs = graph.passes[p].side_effect;
        each(demands[p],
             [&](ResourceIndex r, std::size_t s, const Demand& d) { runs = runs || (d.writes != 0 && wanted[r][s]); });
        if (!runs) {
            plan.dropped.push_back(static_cast<std::uint32_t>(p));
            continue;
        }
        plan.passes.push_back({static_cast<std::uint32_t>(p), {}, find_unstored(graph, graph.passes[p], wanted)});
        each(demands[p], [&](ResourceIndex r, std::size_t s, const Demand& d) {
            if (d.discard) wanted[r][s] = false;
            if (d.consumes()) wanted[r][s] = true;
        });
    }
    std::reverse(plan.passes.begin(), plan.passes.end());
    std::reverse(plan.dropped.begin(), plan.dropped.end());
}

std::vector<Lifetime> find_lifetimes(const GraphDesc& graph, const std::vector<PassDemands>& demands,
                                     const PassDemands& finals, const Plan& plan)
{
    std::vector<Lifetime> out(graph.resources.size());
    for (std::uint32_t i = 0; i < plan.passes.size(); ++i) {
        for (const ResourceDemand& d : demands[plan.passes[i].pass]) {
            Lifetime& life = out[d.resource];
            if (!life.used()) life.first = i;
            life.last = i;
        }
    }
    for (std::size_t r = 0; r < out.size(); ++r) {
        if (graph.resources[r].keep) out[r].last = Lifetime::never;
    }
    for (const ResourceDemand& d : finals) out[d.resource].last = Lifetime::never;
    return out;
}

using States = std::vector<std::vector<SubresourceState>>;

void apply(const GraphDesc& graph, const PassDemands& demands, bool last, States& states, std::vector<Barrier>& out)
{
    for (const ResourceDemand& d : demands) {
        std::vector<std::optional<Barrier>> barriers(d.subresources.size());
        for (std::size_t s = 0; s < barriers.size(); ++s) {
            if (d.subresources[s].used()) barriers[s] = states[d.resource][s].use(d.subresources[s], last);
        }
        append_merged(graph.resources[d.resource], d.resource, barriers, out);
    }
}

/// Goes through the frame from its start, writing the barriers into the plan; returns the state at its end.
States walk(const GraphDesc& graph, const std::vector<PassDemands>& demands, const PassDemands& finals,
            const std::vector<MemoryWait>& waits, Plan& plan)
{
    States states;
    for (ResourceIndex r = 0; r < graph.resources.size(); ++r) {
        const ResourceDesc& resource = graph.resources[r];
        if (resource.initial_parts.empty()) {
            states.emplace_back(subresource_count(resource), SubresourceState(resource, waits[r]));
            continue;
        }
        std::vector<SubresourceState>& parts = states.emplace_back();
        for (const PartState& part : resource.initial_parts) parts.emplace_back(resource.is_image, part);
    }
    for (PlannedPass& planned : plan.passes) {
        planned.barriers.clear();
        apply(graph, demands[planned.pass], false, states, planned.barriers);
    }
    plan.final_barriers.clear();
    apply(graph, finals, true, states, plan.final_barriers);
    return states;
}

/// What each resource leaves to be waited for, its subresources together.
std::vector<Scope> outstanding(const GraphDesc& graph, const States& states)
{
    std::vector<Scope> out(states.size());
    for (std::size_t r = 0; r < states.size(); ++r) {
        for (const SubresourceState& s : states[r]) {
            if (graph.resources[r].transient && !s.used()) continue;
            out[r].stages |= s.outstanding().stages;
            out[r].access |= s.outstanding().access;
        }
    }
    return out;
}

/// The state of each subresource of one resource, for the next frame.
std::vector<PartState> final_parts(const ResourceDesc& resource, const std::vector<SubresourceState>& states)
{
    std::vector<PartState> out;
    for (std::size_t s = 0; s < resource.initial_parts.size(); ++s) {
        out.push_back({states[s].last_access(), states[s].outstanding(),
                       states[s].written() || resource.initial_parts[s].defined});
    }
    return out;
}

} // namespace

Plan make_plan(const GraphDesc& graph, std::span<const FinalUse> finals)
{
    const std::vector<PassDemands> demands = collect_demands(graph);
    const PassDemands ends = collect_finals(graph, finals);
    check_reads(graph, demands, ends);

    Plan plan;
    choose_passes(graph, demands, ends, plan);
    place_transients(graph, find_lifetimes(graph, demands, ends, plan), plan);

    // How a resource ends does not depend on what its first use waits for. So a first walk, in which transients wait
    // for nothing, tells what the second has to wait for, be it of this frame or of the one before.
    const std::vector<MemoryWait> nothing(graph.resources.size());
    const States ended = walk(graph, demands, ends, nothing, plan);
    const std::vector<MemoryWait> waits = memory_waits(graph, plan, outstanding(graph, ended));
    const States states = walk(graph, demands, ends, waits, plan);

    for (const std::vector<SubresourceState>& resource : states) plan.final_access.push_back(resource[0].last_access());
    plan.final_waits = outstanding(graph, states);
    for (std::size_t r = 0; r < states.size(); ++r)
        plan.final_parts.push_back(final_parts(graph.resources[r], states[r]));
    return plan;
}

} // namespace atrium::graph
