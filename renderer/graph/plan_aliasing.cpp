// Where transient resources live, and whom their memory makes them wait for.

#include "renderer/graph/plan_state.hpp"

#include <algorithm>
#include <numeric>

namespace atrium::graph::detail {
namespace {

struct Occupant {
    ResourceIndex resource;
    std::uint64_t begin, end;
};

bool meet(const Lifetime& a, const Lifetime& b)
{
    return a.first <= b.last && b.first <= a.last;
}

/// `alignment` is a power of two and `offset` at most a block's size, which stays clear of the end of the numbers.
std::uint64_t align_up(std::uint64_t offset, std::uint64_t alignment)
{
    return (offset + alignment - 1) & ~(alignment - 1);
}

/// The lowest offset in a block of `capacity` bytes that stays clear of `taken`, which is sorted by begin.
std::optional<std::uint64_t> find_gap(const std::vector<Occupant>& taken, const ResourceDesc& resource,
                                      std::uint64_t capacity)
{
    std::uint64_t offset = 0;
    for (const Occupant& o : taken) {
        if (o.begin >= offset && o.begin - offset >= resource.size) break;
        offset = std::max(offset, align_up(o.end, resource.alignment));
    }
    if (offset > capacity || capacity - offset < resource.size) return std::nullopt;
    return offset;
}

/// The used transients that want a place, largest first; equal ones in order of declaration.
std::vector<ResourceIndex> by_size(const GraphDesc& graph, const std::vector<Lifetime>& lifetimes)
{
    std::vector<ResourceIndex> order;
    for (ResourceIndex r = 0; r < graph.resources.size(); ++r) {
        if (graph.resources[r].transient && graph.resources[r].size > 0 && lifetimes[r].used()) order.push_back(r);
    }
    std::stable_sort(order.begin(), order.end(), [&](ResourceIndex a, ResourceIndex b) {
        return graph.resources[a].size > graph.resources[b].size;
    });
    return order;
}

} // namespace

void place_transients(const GraphDesc& graph, const std::vector<Lifetime>& lifetimes, Plan& plan)
{
    plan.placements.assign(graph.resources.size(), {});
    std::vector<std::vector<Occupant>> blocks; // each sorted by begin
    for (const ResourceIndex r : by_size(graph, lifetimes)) {
        const ResourceDesc& resource = graph.resources[r];
        std::uint32_t block = 0;
        std::uint64_t offset = 0;
        for (; block < blocks.size(); ++block) {
            if (plan.block_class[block] != resource.memory_class) continue;
            std::vector<Occupant> taken;
            std::copy_if(blocks[block].begin(), blocks[block].end(), std::back_inserter(taken),
                         [&](const Occupant& o) { return meet(lifetimes[r], lifetimes[o.resource]); });
            const auto gap = find_gap(taken, resource, plan.block_sizes[block]);
            if (!gap) continue;
            offset = *gap;
            break;
        }
        if (block == blocks.size()) {
            blocks.emplace_back();
            plan.block_sizes.push_back(resource.size);
            plan.block_class.push_back(resource.memory_class);
            plan.block_alignment.push_back(resource.alignment);
        }
        plan.block_alignment[block] = std::max(plan.block_alignment[block], resource.alignment);
        plan.placements[r] = {block, offset};
        const Occupant occupant{r, offset, offset + resource.size};
        const auto place = std::upper_bound(blocks[block].begin(), blocks[block].end(), occupant,
                                            [](const Occupant& a, const Occupant& b) { return a.begin < b.begin; });
        blocks[block].insert(place, occupant);
    }
}

std::vector<MemoryWait> memory_waits(const GraphDesc& graph, const Plan& plan, const std::vector<Scope>& outstanding)
{
    const auto share = [&](ResourceIndex a, ResourceIndex b) {
        const Placement &pa = plan.placements[a], &pb = plan.placements[b];
        return pa.block != Placement{}.block && pa.block == pb.block &&
               pa.offset < pb.offset + graph.resources[b].size && pb.offset < pa.offset + graph.resources[a].size;
    };
    // Earlier occupants are of this frame, later ones and the resource itself of the frame before.
    std::vector<MemoryWait> waits(graph.resources.size());
    for (ResourceIndex r = 0; r < graph.resources.size(); ++r) {
        if (!graph.resources[r].transient) continue;
        waits[r].scope = outstanding[r];
        for (ResourceIndex other = 0; other < graph.resources.size(); ++other) {
            if (other == r || !share(r, other)) continue;
            waits[r].scope.stages |= outstanding[other].stages;
            waits[r].scope.access |= outstanding[other].access;
            waits[r].others = true;
        }
    }
    return waits;
}

} // namespace atrium::graph::detail
