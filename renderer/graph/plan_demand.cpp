// What the passes ask, checked and brought to one demand per subresource.

#include "renderer/graph/plan_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace atrium::graph::detail {
namespace {

constexpr std::uint32_t bit(Access access)
{
    return 1u << static_cast<std::uint32_t>(access);
}

/// Who asks: a pass, or the end of the frame.
std::string asker(const PassDesc* pass)
{
    return pass ? fmt::format("pass \"{}\"", pass->name) : "the end of the frame";
}

[[noreturn]] void refuse(const PassDesc* pass, const ResourceDesc& resource, const std::string& why)
{
    throw std::logic_error(fmt::format("graph: {} uses \"{}\" {}", asker(pass), resource.name, why));
}

bool for_images_only(Access access)
{
    return access == Access::color_write || access == Access::resolve_write || access == Access::depth_write ||
           access == Access::depth_read || access == Access::present;
}

bool can_have(const ResourceDesc& resource, Access access)
{
    return resource.is_image ? gpu::info(access).layout != VK_IMAGE_LAYOUT_UNDEFINED : !for_images_only(access);
}

/// Multisampled images can only be drawn to and sampled.
bool takes_samples(Access access)
{
    switch (access) {
    case Access::color_write:
    case Access::depth_write:
    case Access::depth_read:
    case Access::sampled_fragment:
    case Access::sampled_compute:
    case Access::sampled_vertex:
        return true;
    default:
        return false;
    }
}

bool inside(std::uint32_t first, std::uint32_t count, std::uint32_t end)
{
    return count > 0 && first < end && count <= end - first;
}

void check_use(const GraphDesc& graph, const PassDesc* pass, const Use& use)
{
    if (use.resource >= graph.resources.size()) {
        throw std::logic_error(fmt::format("graph: {} uses resource {}, and there are {}", asker(pass), use.resource,
                                           graph.resources.size()));
    }
    const ResourceDesc& resource = graph.resources[use.resource];
    if (use.access == Access::none || use.access >= Access::count) refuse(pass, resource, "without saying how");
    const std::string name = gpu::info(use.access).name;
    if (!can_have(resource, use.access)) {
        refuse(pass, resource,
               fmt::format("as {}, which {} cannot be", name, resource.is_image ? "an image" : "a buffer"));
    }
    if (resource.is_image && resource.samples > 1 && !takes_samples(use.access))
        refuse(pass, resource, fmt::format("as {}, which an image with {} samples cannot be", name, resource.samples));
    if (use.discard && !gpu::is_write(use.access)) refuse(pass, resource, "as " + name + " and discards what it reads");
    if (resource.is_image && (!inside(use.range.first_mip, use.range.mips, resource.mips) ||
                              !inside(use.range.first_layer, use.range.layers, resource.layers))) {
        refuse(pass, resource,
               fmt::format("outside its {} mips and {} layers, from mip {} for {} and from layer {} for {}",
                           resource.mips, resource.layers, use.range.first_mip, use.range.mips, use.range.first_layer,
                           use.range.layers));
    }
}

void check_resource(const ResourceDesc& resource)
{
    const auto wrong = [&](const char* why) {
        throw std::logic_error(fmt::format("graph: resource \"{}\" {}", resource.name, why));
    };
    if (resource.is_image && (resource.mips == 0 || resource.layers == 0)) wrong("has no mips or no layers");
    if (resource.samples > 1 && resource.mips > 1) wrong("has several samples and several mips");
    if (!std::has_single_bit(resource.samples)) wrong("has a number of samples that is not a power of two");
    if (!resource.initial_parts.empty()) {
        if (resource.transient) wrong("is transient and has a state from before");
        if (resource.initial_parts.size() != subresource_count(resource)) wrong("has not one state for each part");
        for (const PartState& part : resource.initial_parts) {
            if (part.last != Access::none && !can_have(resource, part.last))
                wrong("was last used in a way that it cannot be");
        }
    }
    if (!std::has_single_bit(resource.alignment)) wrong("has an alignment that is not a power of two");
    if (resource.size > std::uint64_t{1} << 48) wrong("is larger than any memory");
    if (resource.initial >= Access::count) wrong("was last used in no way there is");
    if (resource.initial != Access::none && !can_have(resource, resource.initial)) {
        wrong("was last used in a way that it cannot be");
    }
}

/// Adds one more use to what the pass asks of a subresource.
void add(Demand& demand, const Use& use, const PassDesc* pass, const ResourceDesc& resource)
{
    const gpu::AccessInfo& wanted = gpu::info(use.access);
    const VkImageLayout layout = resource.is_image ? wanted.layout : VK_IMAGE_LAYOUT_UNDEFINED;
    const bool first = !demand.used();
    // A depth attachment that is only tested may be sampled where it stands: its own layout serves both.
    const bool keeps_layout = demand.kind == Access::depth_read && use.access == Access::sampled_fragment;
    const bool takes_layout = use.access == Access::depth_read && demand.kinds == bit(Access::sampled_fragment);
    if (!first && demand.layout != layout && !keeps_layout && !takes_layout) {
        refuse(pass, resource,
               fmt::format("as {} and as {}, which need two layouts", gpu::info(demand.kind).name, wanted.name));
    }
    if (!keeps_layout) demand.layout = layout;
    if (first || takes_layout || (wanted.writes != 0 && demand.writes == 0)) demand.kind = use.access;
    demand.discard = first ? use.discard : demand.discard && use.discard;
    demand.kinds |= bit(use.access);
    demand.stages |= wanted.stages;
    demand.access |= wanted.access;
    demand.writes |= wanted.writes;
}

ResourceDemand& demand_on(const GraphDesc& graph, ResourceIndex index, PassDemands& demands)
{
    const auto found = std::find_if(demands.begin(), demands.end(), [&](const auto& d) { return d.resource == index; });
    if (found != demands.end()) return *found;
    demands.push_back({index, std::vector<Demand>(subresource_count(graph.resources[index]))});
    return demands.back();
}

} // namespace

std::size_t subresource_count(const ResourceDesc& resource)
{
    return resource.is_image ? std::size_t{resource.mips} * resource.layers : 1;
}

std::vector<PassDemands> collect_demands(const GraphDesc& graph)
{
    for (const ResourceDesc& resource : graph.resources) check_resource(resource);
    std::vector<PassDemands> out(graph.passes.size());
    for (std::size_t p = 0; p < graph.passes.size(); ++p) {
        const PassDesc& pass = graph.passes[p];
        for (const Use& use : pass.uses) {
            check_use(graph, &pass, use);
            const ResourceDesc& resource = graph.resources[use.resource];
            std::vector<Demand>& grid = demand_on(graph, use.resource, out[p]).subresources;
            each_part(resource, use.range, [&](std::size_t s) { add(grid[s], use, &pass, resource); });
        }
    }
    return out;
}

PassDemands collect_finals(const GraphDesc& graph, std::span<const FinalUse> finals)
{
    PassDemands out;
    for (const FinalUse& final_use : finals) {
        Use use{final_use.resource, final_use.access};
        check_use(graph, nullptr, use);
        const ResourceDesc& resource = graph.resources[use.resource];
        ResourceDemand& demand = demand_on(graph, use.resource, out);
        for (Demand& d : demand.subresources) {
            if (d.used()) refuse(nullptr, resource, "twice");
            add(d, use, nullptr, resource);
        }
    }
    return out;
}

void check_reads(const GraphDesc& graph, const std::vector<PassDemands>& passes, const PassDemands& finals)
{
    std::vector<std::vector<bool>> written;
    for (const ResourceDesc& r : graph.resources) {
        std::vector<bool>& parts = written.emplace_back(subresource_count(r), !r.transient);
        for (std::size_t s = 0; s < r.initial_parts.size(); ++s) parts[s] = r.initial_parts[s].defined;
    }

    const auto check = [&](const PassDemands& demands, const PassDesc* pass) {
        for (const ResourceDemand& d : demands) {
            const ResourceDesc& resource = graph.resources[d.resource];
            for (std::size_t s = 0; s < d.subresources.size(); ++s) {
                const Demand& demand = d.subresources[s];
                if (demand.used() && demand.writes == 0 && !written[d.resource][s]) {
                    const std::string part =
                        d.subresources.size() == 1
                            ? ""
                            : fmt::format(" (mip {}, layer {})", s % resource.mips, s / resource.mips);
                    throw std::logic_error(fmt::format("graph: {} reads \"{}\"{}, which no earlier pass wrote",
                                                       asker(pass), resource.name, part));
                }
                if (demand.writes != 0) written[d.resource][s] = true;
            }
        }
    };
    for (std::size_t p = 0; p < passes.size(); ++p) check(passes[p], &graph.passes[p]);
    check(finals, nullptr);
}

} // namespace atrium::graph::detail
