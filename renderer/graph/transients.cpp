#include "renderer/graph/transients.hpp"

#include <algorithm>

namespace atrium::graph {

VkImageUsageFlags usage_of(ResourceIndex resource, const std::vector<Pass>& passes)
{
    VkImageUsageFlags usage = 0;
    for (const Pass& pass : passes) {
        for (const Use& use : pass.uses) {
            if (use.resource != resource) continue;
            switch (use.access) {
            case Access::color_write:
            case Access::resolve_write:
                usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
                break;
            case Access::depth_write:
            case Access::depth_read:
                usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
                break;
            case Access::sampled_fragment:
            case Access::sampled_compute:
            case Access::sampled_vertex:
                usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
                break;
            case Access::storage_read:
            case Access::storage_write:
            case Access::storage_fragment:
                usage |= VK_IMAGE_USAGE_STORAGE_BIT;
                break;
            case Access::transfer_read:
                usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
                break;
            case Access::transfer_write:
                usage |= VK_IMAGE_USAGE_TRANSFER_DST_BIT;
                break;
            default:
                break;
            }
        }
    }
    return usage;
}

void Runner::Transients::release()
{
    entries_.clear();
    blocks_.clear();
    placed_.clear();
    is_placed_ = false;
}

void Runner::Transients::make(Entry& entry)
{
    const TransientDesc& d = entry.desc;
    if (d.imported) return;
    if (d.is_image) {
        if (d.usage == 0) return; // declared, never used
        entry.image = gpu::Image::create_unbound(
            device_, d.name,
            {d.desc.format, d.desc.width, d.desc.height, d.desc.mips, d.desc.layers, d.usage, d.desc.samples});
        entry.requirements = entry.image.requirements();
    } else {
        entry.buffer = gpu::Buffer(device_, d.name, d.bytes, buffer_usage, gpu::MemoryUse::device);
    }
}

void Runner::Transients::create(std::size_t count, const std::function<TransientDesc(ResourceIndex)>& describe)
{
    std::vector<TransientDesc> wanted;
    for (std::size_t i = 0; i < count; ++i) wanted.push_back(describe(static_cast<ResourceIndex>(i)));
    if (std::equal(wanted.begin(), wanted.end(), entries_.begin(), entries_.end(),
                   [](const TransientDesc& a, const Entry& b) { return a == b.desc; })) {
        return;
    }
    make_all(std::move(wanted));
}

/// If it fails half way, there are no resources left, and the next call creates all of them.
void Runner::Transients::make_all(std::vector<TransientDesc> wanted)
{
    release();
    try {
        entries_.resize(wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            entries_[i].desc = std::move(wanted[i]);
            make(entries_[i]);
        }
    } catch (...) {
        release();
        throw;
    }
}

void Runner::Transients::requirements(ResourceIndex r, ResourceDesc& out) const
{
    const Entry& entry = entries_[r];
    out.size = entry.requirements.size;
    out.alignment = std::max<std::uint64_t>(entry.requirements.alignment, 1);
    out.memory_class = entry.requirements.memoryTypeBits;
}

void Runner::Transients::place(const Plan& plan)
{
    const auto same = [](const Placement& a, const Placement& b) { return a.block == b.block && a.offset == b.offset; };
    if (is_placed_ && std::equal(plan.placements.begin(), plan.placements.end(), placed_.begin(), placed_.end(), same))
        return;
    if (is_placed_) { // An image is bound once and for all: make them anew.
        std::vector<TransientDesc> again;
        for (Entry& entry : entries_) again.push_back(std::move(entry.desc));
        make_all(std::move(again));
    }
    try {
        bind(plan);
    } catch (...) {
        release();
        throw;
    }
    placed_ = plan.placements;
    is_placed_ = true;
}

void Runner::Transients::bind(const Plan& plan)
{
    for (std::size_t b = 0; b < plan.block_sizes.size(); ++b) {
        blocks_.emplace_back(device_,
                             VkMemoryRequirements{plan.block_sizes[b], plan.block_alignment[b], plan.block_class[b]});
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        Entry& entry = entries_[i];
        const Placement& placement = plan.placements[i];
        if (!entry.desc.is_image || placement.block == ~0u) continue;
        entry.image.bind(blocks_[placement.block].handle(), placement.offset);
    }
}

} // namespace atrium::graph
