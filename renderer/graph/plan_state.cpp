// The rules by which one use of a subresource follows another.
//
// An execution dependency carries on through a chain: write -> barrier -> reader -> barrier -> next write. Each reader
// is ordered after the last write, which the first barrier has made available. So a write after reads waits for the
// readers only and needs no source access, and yet the last write is available and, through the destination access,
// visible.

#include "renderer/graph/plan_state.hpp"

#include <algorithm>

namespace atrium::graph::detail {

SubresourceState::SubresourceState(const ResourceDesc& resource, const MemoryWait& wait)
{
    if (resource.transient) {
        write_ = wait.scope;
        takes_memory_ = wait.others;
        return;
    }
    *this = SubresourceState(resource.is_image, {resource.initial, resource.initial_wait, true});
}

SubresourceState::SubresourceState(bool is_image, const PartState& before)
{
    if (before.last == Access::none) return;
    const gpu::AccessInfo& initial = gpu::info(before.last);
    last_ = before.last;
    if (is_image) layout_ = initial.layout;
    write_ = {initial.stages | before.wait.stages, initial.writes | before.wait.access};
    if (write_.access != 0) return;
    // Who wrote it is not known any more, only that these readers came after and saw it.
    readers_ = write_.stages;
    visible_.push_back({initial.stages, initial.access});
}

Scope SubresourceState::outstanding() const
{
    return readers_ != 0 ? Scope{readers_, 0} : write_;
}

bool SubresourceState::sees_last_write(const Demand& demand) const
{
    if (write_.stages == 0) return true; // nothing, or the host before the frame was submitted
    VkPipelineStageFlags2 left = demand.stages;
    while (left != 0) {
        const VkPipelineStageFlags2 stage = left & (~left + 1);
        left &= ~stage;
        VkAccessFlags2 seen = 0;
        for (const Scope& v : visible_) seen |= (v.stages & stage) != 0 ? v.access : 0;
        if ((demand.access & ~seen) != 0) return false;
    }
    return true;
}

std::optional<Barrier> SubresourceState::wait_for(const Scope& source, const Demand& demand, bool relayout) const
{
    if (source.stages == 0 && !relayout) return std::nullopt;
    Barrier out;
    out.src_stages = source.stages;
    out.src_access = source.access;
    // Presenting has no stage to wait for. The acquire semaphore holds up stages, and this continues from them.
    if (last_ == Access::present) out.src_stages |= demand.stages;
    out.dst_stages = demand.stages;
    out.dst_access = demand.access;
    out.old_layout = demand.discard ? VK_IMAGE_LAYOUT_UNDEFINED : layout_;
    out.new_layout = demand.layout;
    out.takes_memory = takes_memory_;
    return out;
}

std::optional<Barrier> SubresourceState::use(const Demand& demand, bool last)
{
    const bool relayout = demand.layout != layout_;
    const bool seen = sees_last_write(demand);
    // The final use hands over: one who waits for it alone must find all readers done.
    const bool gathers = last && (!seen || (readers_ & ~demand.stages) != 0);

    std::optional<Barrier> barrier;
    if (demand.writes != 0 || relayout || gathers)
        barrier = wait_for(outstanding(), demand, relayout);
    else if (!seen)
        barrier = wait_for(write_, demand, relayout);

    if (demand.writes != 0) {
        write_ = {demand.stages, demand.writes};
        readers_ = 0;
        visible_.clear();
    } else {
        if (relayout || gathers) { // everything before is behind this barrier, and available
            write_ = {demand.stages, 0};
            readers_ = 0;
            visible_.clear();
        }
        if (barrier) {
            visible_.push_back({demand.stages, demand.access});
            readers_ &= ~barrier->src_stages; // who waits for this reader waits for those
        }
        readers_ |= demand.stages;
    }
    layout_ = demand.layout;
    last_ = demand.kind;
    used_ = true;
    written_ = written_ || demand.writes != 0;
    takes_memory_ = false;
    return barrier;
}

namespace {

bool alike(const std::optional<Barrier>& a, const std::optional<Barrier>& b)
{
    if (!a || !b) return false;
    return a->src_stages == b->src_stages && a->dst_stages == b->dst_stages && a->src_access == b->src_access &&
           a->dst_access == b->dst_access && a->old_layout == b->old_layout && a->new_layout == b->new_layout &&
           a->takes_memory == b->takes_memory;
}

} // namespace

void append_merged(const ResourceDesc& resource, ResourceIndex index,
                   const std::vector<std::optional<Barrier>>& barriers, std::vector<Barrier>& out)
{
    const std::uint32_t mips = resource.is_image ? resource.mips : 1;
    const std::uint32_t layers = resource.is_image ? resource.layers : 1;
    std::vector<bool> done(barriers.size(), false);
    const auto at = [&](std::uint32_t layer, std::uint32_t mip) { return std::size_t{layer} * mips + mip; };

    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        for (std::uint32_t mip = 0; mip < mips; ++mip) {
            const std::optional<Barrier>& first = barriers[at(layer, mip)];
            if (!first || done[at(layer, mip)]) continue;
            const auto joins = [&](std::uint32_t l, std::uint32_t m) {
                return !done[at(l, m)] && alike(barriers[at(l, m)], first);
            };
            std::uint32_t end_mip = mip + 1, end_layer = layer + 1;
            while (end_mip < mips && joins(layer, end_mip)) ++end_mip;
            const auto row_joins = [&](std::uint32_t l) {
                for (std::uint32_t m = mip; m < end_mip; ++m) {
                    if (!joins(l, m)) return false;
                }
                return true;
            };
            while (end_layer < layers && row_joins(end_layer)) ++end_layer;
            for (std::uint32_t l = layer; l < end_layer; ++l) {
                for (std::uint32_t m = mip; m < end_mip; ++m) done[at(l, m)] = true;
            }
            Barrier merged = *first;
            merged.resource = index;
            merged.range = {mip, end_mip - mip, layer, end_layer - layer};
            out.push_back(merged);
        }
    }
}

} // namespace atrium::graph::detail
