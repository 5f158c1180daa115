#pragma once
// What the parts of make_plan() share: what a pass asks of each subresource, and what is known of each subresource
// between two passes. Internal to the graph.

#include "renderer/graph/plan.hpp"

#include <cstddef>
#include <optional>

namespace atrium::graph::detail {

/// What one pass asks of one subresource, all its uses of it taken together.
struct Demand {
    Access kind = Access::none; ///< the use that decides the layout and what comes after it; none: not used
    std::uint32_t kinds = 0;    ///< all the uses, one bit per Access
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0, writes = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED; ///< always UNDEFINED for buffers
    bool discard = false;                             ///< no use needs the earlier contents

    [[nodiscard]] bool used() const { return kinds != 0; }
    /// The result depends on what was there before, if only because attachments are loaded.
    [[nodiscard]] bool consumes() const { return used() && !discard && (writes == 0 || (access & ~writes) != 0); }
};

/// What one pass asks of one resource, by subresource: layer after layer, the mips of each together.
struct ResourceDemand {
    ResourceIndex resource = 0;
    std::vector<Demand> subresources;
};
using PassDemands = std::vector<ResourceDemand>;

[[nodiscard]] std::size_t subresource_count(const ResourceDesc& resource);

/// Calls `function` with the index of each subresource in the range.
template <class F>
void each_part(const ResourceDesc& resource, const SubresourceRange& of_image, F&& function)
{
    const SubresourceRange range = resource.is_image ? of_image : SubresourceRange{};
    const std::uint32_t mips = resource.is_image ? resource.mips : 1;
    for (std::uint32_t layer = range.first_layer; layer < range.first_layer + range.layers; ++layer) {
        for (std::uint32_t mip = range.first_mip; mip < range.first_mip + range.mips; ++mip)
            function(std::size_t{layer} * mips + mip);
    }
}

/// What each pass of the graph asks, in order of declaration; and what the end of the frame asks.
/// Both throw std::logic_error for what make_plan() says.
[[nodiscard]] std::vector<PassDemands> collect_demands(const GraphDesc& graph);
[[nodiscard]] PassDemands collect_finals(const GraphDesc& graph, std::span<const FinalUse> finals);

/// Throws std::logic_error when a pass or the end of the frame reads what nobody wrote.
void check_reads(const GraphDesc& graph, const std::vector<PassDemands>& passes, const PassDemands& finals);

/// What the first use of a transient waits for.
struct MemoryWait {
    Scope scope;
    bool others = false; ///< some of it used the memory as another resource
};

/// The synchronisation state of one subresource. Stages and accesses only grow between two writes.
class SubresourceState {
public:
    SubresourceState() = default;
    SubresourceState(const ResourceDesc& resource, const MemoryWait& wait);
    SubresourceState(bool is_image, const PartState& before);

    /// The dependency that `demand` needs on what came before, if any; the state after it.
    /// @param last  the final use: readers before it are waited for too, even by a reader
    std::optional<Barrier> use(const Demand& demand, bool last = false);

    /// What has to be waited for before the subresource may be overwritten.
    [[nodiscard]] Scope outstanding() const;
    [[nodiscard]] Access last_access() const { return last_; }
    [[nodiscard]] bool used() const { return used_; }
    [[nodiscard]] bool written() const { return written_; } ///< by a pass of this frame

private:
    [[nodiscard]] bool sees_last_write(const Demand& demand) const;
    [[nodiscard]] std::optional<Barrier> wait_for(const Scope& source, const Demand& demand, bool relayout) const;

    VkImageLayout layout_ = VK_IMAGE_LAYOUT_UNDEFINED;
    Access last_ = Access::none;
    bool used_ = false;                 ///< by a pass of this frame
    bool written_ = false;              ///< by a pass of this frame
    bool takes_memory_ = false;         ///< until the first use
    Scope write_;                       ///< last write, or change of layout (available by itself: no access)
    VkPipelineStageFlags2 readers_ = 0; ///< since then; each of them is ordered after the write
    std::vector<Scope> visible_;        ///< to whom the write is visible
};

/// Barriers of one resource by subresource, put together into as few rectangles of mips and layers as come easily.
void append_merged(const ResourceDesc& resource, ResourceIndex index,
                   const std::vector<std::optional<Barrier>>& barriers, std::vector<Barrier>& out);

/// First and last planned pass that uses a resource.
struct Lifetime {
    static constexpr std::uint32_t never = ~0u;
    std::uint32_t first = never, last = 0; ///< last is `never` for what is wanted after the frame

    [[nodiscard]] bool used() const { return first != never; }
};

/// Gives every used transient a place; see make_plan(). Greedy by size: the largest open a block, smaller ones go to
/// the first place that is free for as long as they live.
void place_transients(const GraphDesc& graph, const std::vector<Lifetime>& lifetimes, Plan& plan);

/// What the first use of each transient waits for, from what every resource leaves outstanding at the end of a frame.
[[nodiscard]] std::vector<MemoryWait> memory_waits(const GraphDesc& graph, const Plan& plan,
                                                   const std::vector<Scope>& outstanding);

} // namespace atrium::graph::detail
