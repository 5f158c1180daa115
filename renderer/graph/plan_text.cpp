// A plan as text for people and tests, and as a picture for Graphviz.

#include "renderer/graph/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <utility>

namespace atrium::graph {
namespace {

struct BitName {
    std::uint64_t bits;
    const char* name;
};

constexpr std::array stage_names{
    BitName{VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, "indirect"},
    BitName{VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT, "index"},
    BitName{VK_PIPELINE_STAGE_2_VERTEX_ATTRIBUTE_INPUT_BIT, "vertex_input"},
    BitName{VK_PIPELINE_STAGE_2_PRE_RASTERIZATION_SHADERS_BIT, "vertex"},
    BitName{VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT, "early_depth"},
    BitName{VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, "fragment"},
    BitName{VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT, "late_depth"},
    BitName{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, "color"},
    BitName{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, "compute"},
    BitName{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, "transfer"},
    BitName{VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR, "acceleration_build"},
    BitName{VK_PIPELINE_STAGE_2_HOST_BIT, "host"},
};

constexpr std::array access_names{
    BitName{VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, "indirect_read"},
    BitName{VK_ACCESS_2_INDEX_READ_BIT, "index_read"},
    BitName{VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT, "vertex_read"},
    BitName{VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, "sampled_read"},
    BitName{VK_ACCESS_2_SHADER_STORAGE_READ_BIT, "storage_read"},
    BitName{VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, "storage_write"},
    BitName{VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT, "color_read"},
    BitName{VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, "color_write"},
    BitName{VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT, "depth_read"},
    BitName{VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, "depth_write"},
    BitName{VK_ACCESS_2_SHADER_READ_BIT, "shader_read"},
    BitName{VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR, "acceleration_read"},
    BitName{VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR, "acceleration_write"},
    BitName{VK_ACCESS_2_TRANSFER_READ_BIT, "transfer_read"},
    BitName{VK_ACCESS_2_TRANSFER_WRITE_BIT, "transfer_write"},
    BitName{VK_ACCESS_2_HOST_READ_BIT, "host_read"},
};

std::string names_of(std::uint64_t bits, std::span<const BitName> names)
{
    if (bits == 0) return "none";
    std::string out;
    const auto add = [&](const std::string& name) { out += (out.empty() ? "" : "|") + name; };
    for (const BitName& n : names) {
        if ((bits & n.bits) == 0) continue;
        add(n.name);
        bits &= ~n.bits;
    }
    if (bits != 0) add(fmt::format("{:#x}", bits));
    return out;
}

std::string layout_name(VkImageLayout layout)
{
    switch (layout) {
    case VK_IMAGE_LAYOUT_UNDEFINED:
        return "undefined";
    case VK_IMAGE_LAYOUT_GENERAL:
        return "general";
    case VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL:
        return "color";
    case VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL:
        return "depth";
    case VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL:
        return "depth_read_only";
    case VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL:
        return "shader_read_only";
    case VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL:
        return "transfer_src";
    case VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL:
        return "transfer_dst";
    case VK_IMAGE_LAYOUT_PRESENT_SRC_KHR:
        return "present";
    default:
        return fmt::format("layout_{}", static_cast<int>(layout));
    }
}

/// "" for the whole resource, else "[mip 1-2, layer 0]".
std::string range_text(const ResourceDesc& resource, const SubresourceRange& range)
{
    if (!resource.is_image || (range.mips == resource.mips && range.layers == resource.layers)) return "";
    const auto span = [](std::uint32_t first, std::uint32_t count) {
        return count == 1 ? fmt::format("{}", first) : fmt::format("{}-{}", first, first + count - 1);
    };
    return fmt::format("[mip {}, layer {}]", span(range.first_mip, range.mips), span(range.first_layer, range.layers));
}

std::string use_text(const GraphDesc& graph, const Use& use, bool unstored)
{
    const ResourceDesc& resource = graph.resources[use.resource];
    const gpu::AccessInfo& info = gpu::info(use.access);
    return fmt::format("{} {}{}: {}{}{}", info.writes ? "writes" : "reads", resource.name,
                       range_text(resource, use.range), info.name, use.discard ? ", discards" : "",
                       unstored ? ", not stored" : "");
}

std::string barrier_text(const GraphDesc& graph, const Barrier& b)
{
    const ResourceDesc& resource = graph.resources[b.resource];
    std::string out = fmt::format("barrier {}{}: {} ({}) -> {} ({})", resource.name, range_text(resource, b.range),
                                  names_of(b.src_stages, stage_names), names_of(b.src_access, access_names),
                                  names_of(b.dst_stages, stage_names), names_of(b.dst_access, access_names));
    if (b.new_layout != VK_IMAGE_LAYOUT_UNDEFINED) {
        out += fmt::format(", {} -> {}", layout_name(b.old_layout), layout_name(b.new_layout));
    }
    return out + (b.takes_memory ? ", takes memory" : "");
}

/// First and last planned pass of each resource, as text.
std::vector<std::string> lifetimes(const GraphDesc& graph, const Plan& plan)
{
    std::vector<std::string> out;
    for (ResourceIndex r = 0; r < graph.resources.size(); ++r) {
        const std::string* first = nullptr;
        const std::string* last = nullptr;
        for (const PlannedPass& planned : plan.passes) {
            const PassDesc& pass = graph.passes[planned.pass];
            if (std::any_of(pass.uses.begin(), pass.uses.end(), [&](const Use& u) { return u.resource == r; })) {
                if (!first) first = &pass.name;
                last = &pass.name;
            }
        }
        out.push_back(first ? *first + " .. " + *last : "");
    }
    return out;
}

std::vector<ResourceIndex> residents(const Plan& plan, std::uint32_t block)
{
    std::vector<ResourceIndex> out;
    for (ResourceIndex r = 0; r < plan.placements.size(); ++r) {
        if (plan.placements[r].block == block) out.push_back(r);
    }
    std::stable_sort(out.begin(), out.end(), [&](ResourceIndex a, ResourceIndex b) {
        return plan.placements[a].offset < plan.placements[b].offset;
    });
    return out;
}

std::string memory_text(const GraphDesc& graph, const Plan& plan)
{
    std::string out = "memory\n";
    std::uint64_t wanted = 0, used = 0;
    const std::vector<std::string> lives = lifetimes(graph, plan);
    for (std::uint32_t block = 0; block < plan.block_sizes.size(); ++block) {
        used += plan.block_sizes[block];
        out += fmt::format("    block {}: {} bytes, aligned to {}, class {}\n", block, plan.block_sizes[block],
                           plan.block_alignment[block], plan.block_class[block]);
        for (const ResourceIndex r : residents(plan, block)) {
            const ResourceDesc& resource = graph.resources[r];
            wanted += resource.size;
            out += fmt::format("        at {}: {}, {} bytes, {}{}\n", plan.placements[r].offset, resource.name,
                               resource.size, lives[r], resource.keep ? ", kept" : "");
        }
    }
    return out + fmt::format("    {} bytes for {} wanted: {} saved\n", used, wanted, wanted - std::min(wanted, used));
}

std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\n')
            out += "\\n";
        else
            out += c;
    }
    return out + "\"";
}

/// The passes and their uses as nodes and arrows.
std::string dot_passes(const GraphDesc& graph, const Plan& plan)
{
    std::string out;
    std::vector<bool> runs(graph.passes.size(), false);
    for (const PlannedPass& planned : plan.passes) runs[planned.pass] = true;
    for (std::size_t p = 0; p < graph.passes.size(); ++p) {
        const PassDesc& pass = graph.passes[p];
        out += fmt::format("    p{} [shape=box, style={}, label={}];\n", p, runs[p] ? "filled" : "dashed",
                           quoted(pass.name));
        std::set<std::pair<ResourceIndex, Access>> drawn;
        for (const Use& use : pass.uses) {
            if (!drawn.emplace(use.resource, use.access).second) continue;
            const gpu::AccessInfo& info = gpu::info(use.access);
            const std::string arrow =
                info.writes ? fmt::format("p{} -> r{}", p, use.resource) : fmt::format("r{} -> p{}", use.resource, p);
            out += fmt::format("    {} [label={}{}];\n", arrow, quoted(info.name), runs[p] ? "" : ", style=dashed");
        }
    }
    return out;
}

} // namespace

std::string to_text(const GraphDesc& graph, const Plan& plan)
{
    std::string out;
    for (const PlannedPass& planned : plan.passes) {
        const PassDesc& pass = graph.passes[planned.pass];
        out += fmt::format("pass {}{}\n", pass.name, pass.side_effect ? ", always" : "");
        for (const Barrier& b : planned.barriers) out += "    " + barrier_text(graph, b) + "\n";
        for (std::size_t u = 0; u < pass.uses.size(); ++u) {
            const bool unstored = u < 64 && ((planned.unstored >> u) & 1) != 0;
            out += "    " + use_text(graph, pass.uses[u], unstored) + "\n";
        }
    }
    if (!plan.final_barriers.empty()) out += "end of frame\n";
    for (const Barrier& b : plan.final_barriers) out += "    " + barrier_text(graph, b) + "\n";
    if (!plan.dropped.empty()) out += "dropped\n";
    for (const std::uint32_t pass : plan.dropped) out += "    " + graph.passes[pass].name + "\n";
    return plan.block_sizes.empty() ? out : out + memory_text(graph, plan);
}

std::string to_dot(const GraphDesc& graph, const Plan& plan)
{
    std::string out = "digraph frame {\n    rankdir=LR;\n    node [fontname=\"sans-serif\"];\n";
    const auto node = [&](ResourceIndex r) {
        const ResourceDesc& resource = graph.resources[r];
        return fmt::format("r{} [shape=ellipse, style={}, label={}];\n", r, resource.transient ? "solid" : "bold",
                           quoted(resource.name));
    };
    for (std::uint32_t block = 0; block < plan.block_sizes.size(); ++block) {
        out += fmt::format("    subgraph cluster_block{} {{\n        label=\"block {}, {} bytes\";\n", block, block,
                           plan.block_sizes[block]);
        for (const ResourceIndex r : residents(plan, block)) out += "        " + node(r);
        out += "    }\n";
    }
    for (ResourceIndex r = 0; r < graph.resources.size(); ++r) {
        if (plan.placements[r].block == Placement{}.block) out += "    " + node(r);
    }
    return out + dot_passes(graph, plan) + "}\n";
}

} // namespace atrium::graph
