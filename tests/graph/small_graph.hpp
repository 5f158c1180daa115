#pragma once
// Graphs written down in a line or two.

#include "renderer/graph/plan.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace atrium::graph {

using A = Access;

inline constexpr auto color = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
inline constexpr auto fragment = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
inline constexpr auto compute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
inline constexpr auto transfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
inline constexpr auto shader_read = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
inline constexpr auto storage_both = shader_read | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
inline constexpr auto undefined = VK_IMAGE_LAYOUT_UNDEFINED;
inline constexpr auto read_layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;

struct SmallGraph {
    GraphDesc desc;

    ResourceIndex add(ResourceDesc resource)
    {
        desc.resources.push_back(std::move(resource));
        return static_cast<ResourceIndex>(desc.resources.size() - 1);
    }
    /// A transient of `size` bytes; 0 is not placed.
    ResourceIndex image(std::string name, std::uint64_t size = 0)
    {
        return add({.name = std::move(name), .size = size});
    }
    ResourceIndex buffer(std::string name, std::uint64_t size = 0)
    {
        return add({.name = std::move(name), .is_image = false, .size = size});
    }
    ResourceIndex imported_image(std::string name, Access initial)
    {
        return add({.name = std::move(name), .transient = false, .keep = true, .initial = initial});
    }
    ResourceIndex imported_buffer(std::string name, Access initial)
    {
        return add({.name = std::move(name), .is_image = false, .transient = false, .keep = true, .initial = initial});
    }
    /// A pass that always runs.
    void pass(std::string name, std::vector<Use> uses)
    {
        desc.passes.push_back({std::move(name), std::move(uses), true});
    }
    /// A pass that runs when somebody wants what it writes.
    void pass_if_wanted(std::string name, std::vector<Use> uses)
    {
        desc.passes.push_back({std::move(name), std::move(uses), false});
    }
};

/// The message of the refusal; empty when the graph is accepted.
inline std::string refusal(const SmallGraph& g, const std::vector<FinalUse>& finals = {})
{
    try {
        static_cast<void>(make_plan(g.desc, finals));
    } catch (const std::logic_error& error) {
        return error.what();
    }
    return "";
}

inline bool operator==(const SubresourceRange& a, const SubresourceRange& b)
{
    return a.first_mip == b.first_mip && a.mips == b.mips && a.first_layer == b.first_layer && a.layers == b.layers;
}
inline bool operator==(const Barrier& a, const Barrier& b)
{
    return a.resource == b.resource && a.range == b.range && a.src_stages == b.src_stages &&
           a.dst_stages == b.dst_stages && a.src_access == b.src_access && a.dst_access == b.dst_access &&
           a.old_layout == b.old_layout && a.new_layout == b.new_layout && a.takes_memory == b.takes_memory;
}

} // namespace atrium::graph
