// The other two things a plan decides: which passes run, and where transients live.

#include "tests/graph/plan_oracle.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace atrium::graph::oracle {
namespace {

/// One pass on one subresource.
struct Touch {
    bool used = false, writes = false, overwrites = false, consumes = false;
};

Touch touch(const Frame& frame, std::size_t pass, ResourceIndex r, std::uint32_t mip, std::uint32_t layer)
{
    Touch out;
    out.overwrites = true;
    VkAccessFlags2 access = 0, writes = 0;
    for (const Use& use : frame.graph.passes[pass].uses) {
        const auto inside = [](std::uint32_t i, std::uint32_t first, std::uint32_t n) {
            return i >= first && i - first < n;
        };
        if (use.resource != r) continue;
        if (frame.graph.resources[r].is_image && (!inside(mip, use.range.first_mip, use.range.mips) ||
                                                  !inside(layer, use.range.first_layer, use.range.layers))) {
            continue;
        }
        out.used = true;
        out.overwrites = out.overwrites && use.discard;
        access |= gpu::info(use.access).access;
        writes |= gpu::info(use.access).writes;
    }
    out.overwrites = out.overwrites && out.used;
    out.writes = writes != 0;
    out.consumes = out.used && !out.overwrites && (writes == 0 || (access & ~writes) != 0);
    return out;
}

/// Whether what is in the subresource after `pass` comes to some use, given which later passes run.
bool matters(const Frame& frame, const std::vector<bool>& runs, std::size_t pass, ResourceIndex r, std::uint32_t mip,
             std::uint32_t layer)
{
    for (std::size_t later = pass + 1; later < runs.size(); ++later) {
        if (!runs[later]) continue;
        const Touch t = touch(frame, later, r, mip, layer);
        if (t.consumes) return true;
        if (t.overwrites) return false;
    }
    const auto ends = [&](const FinalUse& f) { return f.resource == r; };
    return frame.graph.resources[r].keep || std::any_of(frame.finals.begin(), frame.finals.end(), ends);
}

struct Life {
    std::size_t first = ~std::size_t{0}, last = 0;
};

Life life_of(const Frame& frame, ResourceIndex r)
{
    Life out;
    for (std::size_t p = 0; p < frame.plan.passes.size(); ++p) {
        for (const Use& use : frame.graph.passes[frame.plan.passes[p].pass].uses) {
            if (use.resource != r) continue;
            out.first = std::min(out.first, p);
            out.last = p;
        }
    }
    const auto ends = [&](const FinalUse& f) { return f.resource == r; };
    if (frame.graph.resources[r].keep || std::any_of(frame.finals.begin(), frame.finals.end(), ends)) {
        out.last = ~std::size_t{0};
    }
    return out;
}

} // namespace

std::string passes_problem(const Frame& frame)
{
    const std::size_t count = frame.graph.passes.size();
    std::vector<bool> runs(count, false);
    for (std::size_t p = count; p-- > 0;) {
        runs[p] = frame.graph.passes[p].side_effect;
        for (ResourceIndex r = 0; r < frame.graph.resources.size(); ++r) {
            const ResourceDesc& resource = frame.graph.resources[r];
            for (std::uint32_t layer = 0; layer < resource.layers; ++layer) {
                for (std::uint32_t mip = 0; mip < resource.mips; ++mip) {
                    if (touch(frame, p, r, mip, layer).writes && matters(frame, runs, p, r, mip, layer)) runs[p] = true;
                }
            }
        }
    }
    std::vector<std::uint32_t> run, dropped;
    for (std::uint32_t p = 0; p < count; ++p) (runs[p] ? run : dropped).push_back(p);
    std::vector<std::uint32_t> planned;
    for (const PlannedPass& p : frame.plan.passes) planned.push_back(p.pass);
    if (planned != run) return "other passes run than should";
    return frame.plan.dropped == dropped ? "" : "other passes are dropped than should be";
}

namespace {

/// The uses of one planned pass with a result that is not needed afterwards.
std::uint64_t idle_attachments(const Frame& frame, const std::vector<bool>& runs, std::size_t pass)
{
    std::uint64_t out = 0;
    const std::vector<Use>& uses = frame.graph.passes[pass].uses;
    for (std::size_t u = 0; u < uses.size(); ++u) {
        const Use& use = uses[u];
        if (use.access != Access::color_write && use.access != Access::depth_write) continue;
        bool wanted = false;
        for (std::uint32_t l = use.range.first_layer; l < use.range.first_layer + use.range.layers; ++l) {
            for (std::uint32_t m = use.range.first_mip; m < use.range.first_mip + use.range.mips; ++m)
                wanted = wanted || matters(frame, runs, pass, use.resource, m, l);
        }
        if (!wanted) out |= std::uint64_t{1} << u;
    }
    return out;
}

bool is_written(const Frame& frame, ResourceIndex r, std::uint32_t mip, std::uint32_t layer)
{
    return std::any_of(frame.plan.passes.begin(), frame.plan.passes.end(),
                       [&](const PlannedPass& p) { return touch(frame, p.pass, r, mip, layer).writes; }) ||
           std::any_of(frame.finals.begin(), frame.finals.end(),
                       [&](const FinalUse& f) { return f.resource == r && gpu::is_write(f.access); });
}

} // namespace

std::string contents_problem(const Frame& frame)
{
    std::vector<bool> runs(frame.graph.passes.size(), false);
    for (const PlannedPass& p : frame.plan.passes) runs[p.pass] = true;
    for (const PlannedPass& p : frame.plan.passes) {
        if (p.unstored != idle_attachments(frame, runs, p.pass))
            return "other attachments of " + frame.graph.passes[p.pass].name + " are stored than should be";
    }
    for (ResourceIndex r = 0; r < frame.graph.resources.size(); ++r) {
        const ResourceDesc& resource = frame.graph.resources[r];
        const std::vector<PartState>& ends = frame.plan.final_parts[r];
        if (ends.size() != resource.initial_parts.size()) return resource.name + " ends in other parts than it began";
        for (std::uint32_t s = 0; s < ends.size(); ++s) {
            const bool defined =
                resource.initial_parts[s].defined || is_written(frame, r, s % resource.mips, s / resource.mips);
            if (ends[s].defined != defined) return resource.name + " is said to hold what it does not, or not to";
        }
    }
    return "";
}

std::string placement_problem(const Frame& frame)
{
    const std::vector<ResourceDesc>& resources = frame.graph.resources;
    const Plan& plan = frame.plan;
    if (plan.placements.size() != resources.size()) return "not one placement for each resource";
    for (ResourceIndex r = 0; r < resources.size(); ++r) {
        const ResourceDesc& a = resources[r];
        const Placement& pa = plan.placements[r];
        const Life life = life_of(frame, r);
        const bool wants = a.transient && a.size > 0 && life.first != ~std::size_t{0};
        if (wants != (pa.block != ~0u)) return a.name + " is placed though it should not be, or the other way round";
        if (!wants) continue;
        if (pa.block >= plan.block_sizes.size()) return a.name + " is in no block";
        if (pa.offset + a.size > plan.block_sizes[pa.block]) return a.name + " sticks out of its block";
        if (pa.offset % a.alignment != 0) return a.name + " is not aligned";
        if (plan.block_alignment[pa.block] % a.alignment != 0) return a.name + " is not aligned by its block";
        if (plan.block_class[pa.block] != a.memory_class) return a.name + " is in a block of another class";
        for (ResourceIndex s = 0; s < r; ++s) {
            const Placement& pb = plan.placements[s];
            const Life other = life_of(frame, s);
            const bool in_space =
                pa.block == pb.block && pa.offset < pb.offset + resources[s].size && pb.offset < pa.offset + a.size;
            if (in_space && life.first <= other.last && other.first <= life.last) {
                return fmt::format("{} and {} have the same memory at the same time", a.name, resources[s].name);
            }
        }
    }
    return "";
}

} // namespace atrium::graph::oracle
