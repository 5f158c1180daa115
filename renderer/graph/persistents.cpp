#include "renderer/graph/persistents.hpp"

#include "renderer/graph/transients.hpp"

#include <algorithm>

namespace atrium::graph {
namespace {

/// A resource is released after this number of graphs of its view that did not declare it.
constexpr std::uint32_t kept_frames = 8;

/// Every usage that the format allows: later frames may use the image in other ways than the first.
VkImageUsageFlags usage_of(const gpu::Device& device, const TexDesc& desc)
{
    VkFormatProperties format{};
    vkGetPhysicalDeviceFormatProperties(device.physical(), gpu::vk(desc.format), &format);
    VkImageUsageFlags usage = 0;
    const auto add = [&](VkFormatFeatureFlags feature, VkImageUsageFlags use) {
        if ((format.optimalTilingFeatures & feature) != 0) usage |= use;
    };
    add(VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT, VK_IMAGE_USAGE_SAMPLED_BIT);
    add(VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    add(VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    if (desc.samples > 1) return usage;
    add(VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT, VK_IMAGE_USAGE_STORAGE_BIT);
    add(VK_FORMAT_FEATURE_TRANSFER_SRC_BIT, VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
    add(VK_FORMAT_FEATURE_TRANSFER_DST_BIT, VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    return usage;
}

} // namespace

bool PersistentSlot::holds() const
{
    return !parts.empty() && std::all_of(parts.begin(), parts.end(), [](const PartState& p) { return p.defined; });
}

bool Persistents::Entry::matches(const PersistentUse& use) const
{
    return owner == use.owner && is_image == use.is_image && desc == use.desc && bytes == use.bytes;
}

std::uint32_t Persistents::view(std::string_view name)
{
    const auto found = std::find_if(views_.begin(), views_.end(), [&](const View& v) { return v.name == name; });
    if (found != views_.end()) return static_cast<std::uint32_t>(found - views_.begin());
    views_.push_back({std::string(name)});
    return static_cast<std::uint32_t>(views_.size() - 1);
}

const Persistents::Entry* Persistents::find(std::uint64_t hash, std::string_view key) const
{
    const auto found =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.hash == hash && e.key == key; });
    return found != entries_.end() ? &*found : nullptr;
}

Persistents::Entry& Persistents::entry(const PersistentUse& use)
{
    return *std::find_if(entries_.begin(), entries_.end(),
                         [&](const Entry& e) { return e.hash == use.hash && e.key == use.key; });
}

void Persistents::make(Entry& entry, Slot& slot) const
{
    const TexDesc& d = entry.desc;
    if (entry.is_image) {
        slot.image = gpu::Image(device_, entry.key,
                                {d.format, d.width, d.height, d.mips, d.layers, usage_of(device_, d), d.samples});
    } else {
        slot.buffer = gpu::Buffer(device_, entry.key, entry.bytes, buffer_usage, gpu::MemoryUse::device);
    }
    slot.parts.assign(entry.is_image ? std::size_t{d.mips} * d.layers : 1, {});
}

void Persistents::create(const std::vector<PersistentUse>& uses)
{
    for (const PersistentUse& use : uses) {
        if (!find(use.hash, use.key)) {
            ++epoch_;
            entries_.emplace_back().hash = use.hash;
            entries_.back().key = use.key;
        }
        Entry& e = entry(use);
        if (!e.matches(use)) {
            ++epoch_;
            Entry fresh;
            fresh.hash = use.hash;
            fresh.key = std::move(e.key);
            fresh.owner = use.owner;
            fresh.is_image = use.is_image;
            fresh.desc = use.desc;
            fresh.bytes = use.bytes;
            e = std::move(fresh);
        }
        if (Slot& now = slot(use, false); now.parts.empty()) make(e, now);
        if (Slot& before = slot(use, true); use.history && before.parts.empty()) make(e, before);
    }
}

Persistents::Slot& Persistents::slot(const PersistentUse& use, bool history)
{
    Entry& e = entry(use);
    return e.slots[use.history && !history ? 1 - e.current : e.current];
}

void Persistents::commit(const std::vector<PersistentUse>& uses, std::uint32_t view, const Plan& plan,
                         const std::vector<bool>& written)
{
    ++epoch_;
    const std::uint64_t frame = ++views_[view].frames;
    for (Entry& e : entries_) {
        if (e.view == view) ++e.unused;
    }
    for (const PersistentUse& use : uses) {
        Slot& now = slot(use, false);
        now.parts = plan.final_parts[use.now];
        if (use.before != no_resource) slot(use, true).parts = plan.final_parts[use.before];
        if (written[use.now] || !use.note.empty()) now.note = use.note;
        Entry& e = entry(use);
        e.view = view;
        e.unused = 0;
        if (!written[use.now]) continue;
        e.written = frame;
        if (use.history) e.current = 1 - e.current;
    }
}

void Persistents::release_unused()
{
    std::erase_if(entries_, [](const Entry& e) { return e.owner != Owner::program && e.unused >= kept_frames; });
}

void Persistents::forget()
{
    ++epoch_;
    std::erase_if(entries_, [](const Entry& e) { return e.owner != Owner::program; });
}

} // namespace atrium::graph
