#pragma once
// The memory behind a graph's own images and buffers, kept from frame to frame while the graph stays the same.

#include "renderer/graph/graph.hpp"
#include "renderer/graph/runner.hpp"

#include <functional>
#include <string>
#include <vector>

namespace atrium::graph {

/// Usage of every buffer that the graph creates.
inline constexpr VkBufferUsageFlags buffer_usage =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT |
    VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;

struct TransientDesc {
    std::string name;
    bool is_image = true, imported = false;
    TexDesc desc;
    std::uint64_t bytes = 0;
    VkImageUsageFlags usage = 0;
    bool operator==(const TransientDesc&) const = default;
};

/// How the passes use an image, as Vulkan wants to know it beforehand.
[[nodiscard]] VkImageUsageFlags usage_of(ResourceIndex resource, const std::vector<Pass>& passes);

struct Runner::Transients {
    explicit Transients(const gpu::Device& device) : device_(device) {}

    /// Makes the resources, without memory yet; keeps those of the last frame when all descriptions are the same.
    void create(std::size_t count, const std::function<TransientDesc(ResourceIndex)>& describe);
    /// Size, alignment and memory class of a transient image, for planning. Buffers have memory of their own: size 0.
    void requirements(ResourceIndex r, ResourceDesc& out) const;
    /// Gives images the memory that the plan decided on.
    void place(const Plan& plan);

    [[nodiscard]] const gpu::Image& image(ResourceIndex r) const { return entries_[r].image; }
    [[nodiscard]] const gpu::Buffer& buffer(ResourceIndex r) const { return entries_[r].buffer; }

private:
    struct Entry {
        TransientDesc desc;
        gpu::Image image;
        gpu::Buffer buffer;
        VkMemoryRequirements requirements{};
    };
    void release();
    void make_all(std::vector<TransientDesc> wanted);
    void bind(const Plan& plan);
    void make(Entry& entry);

    const gpu::Device& device_;
    std::vector<gpu::MemoryBlock> blocks_; ///< before entries_: images go first
    std::vector<Entry> entries_;
    std::vector<Placement> placed_;
    bool is_placed_ = false;
};

} // namespace atrium::graph
