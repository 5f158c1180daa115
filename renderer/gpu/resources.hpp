#pragma once
// Buffers, images and samplers that own their memory.

#include "renderer/gpu/device.hpp"
#include "renderer/gpu/format.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct VmaAllocation_T;
using VmaAllocation = VmaAllocation_T*;

namespace atrium::gpu {

/// Where a buffer lives and who writes it.
enum class MemoryUse {
    device,   ///< written and read by the device; mapped too where all device memory is (`mapped()` is then not empty)
    upload,   ///< written by the CPU, read by the device
    readback, ///< written by the device, read by the CPU
};

class Buffer {
public:
    Buffer() = default;
    Buffer(const Device& device, std::string_view name, std::uint64_t size, VkBufferUsageFlags usage, MemoryUse use);
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    [[nodiscard]] VkBuffer handle() const { return buffer_; }
    [[nodiscard]] std::uint64_t size() const { return size_; }
    /// The buffer's bytes in the CPU's address space, or an empty span.
    [[nodiscard]] std::span<std::byte> mapped() const
    {
        return {static_cast<std::byte*>(mapped_), mapped_ ? size_ : 0};
    }
    /// Copies to the start of the mapped memory, and flushes.
    void write(std::span<const std::byte> bytes) const;
    template <class T>
    void write(std::span<const T> items) const
    {
        write(std::as_bytes(items));
    }
    void flush() const;      ///< after the CPU wrote
    void invalidate() const; ///< before the CPU reads

private:
    const Device* device_ = nullptr;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VmaAllocation allocation_ = nullptr;
    void* mapped_ = nullptr;
    std::uint64_t size_ = 0;
};

struct ImageDesc {
    Format format = Format::none;
    std::uint32_t width = 1, height = 1;
    std::uint32_t mips = 1, layers = 1;
    VkImageUsageFlags usage = 0;
    std::uint32_t samples = 1;
};

/// Mip levels and array layers of an image.
struct ImagePart {
    std::uint32_t first_mip = 0, mips = 1, first_layer = 0, layers = 1;
    bool array = false; ///< an array view even for one layer
    bool operator==(const ImagePart&) const = default;
};

/// A 2D image with a view of all of it (an array view if it has several layers) and views of its parts. It has its own
/// memory, or (create_unbound) memory that the owner of a shared block binds.
class Image {
public:
    Image() = default;
    Image(const Device& device, std::string_view name, const ImageDesc& desc);
    ~Image();
    Image(Image&& other) noexcept;
    Image& operator=(Image&& other) noexcept;

    /// Without memory or view: for the graph's transient images. bind() gives both.
    [[nodiscard]] static Image create_unbound(const Device& device, std::string_view name, const ImageDesc& desc);
    /// An image that somebody else made and will destroy, such as a window's.
    [[nodiscard]] static Image of_others(const Device& device, std::string_view name, const ImageDesc& desc,
                                         VkImage image);
    [[nodiscard]] VkMemoryRequirements requirements() const;
    void bind(VmaAllocation block, std::uint64_t offset);

    [[nodiscard]] VkImage handle() const { return image_; }
    [[nodiscard]] VkImageView view() const { return view_; }
    /// View of some mips and layers; an array view for several layers. Created on first use and kept.
    [[nodiscard]] VkImageView view(const ImagePart& part) const;
    [[nodiscard]] const ImageDesc& desc() const { return desc_; }

private:
    [[nodiscard]] ImagePart whole() const { return {0, desc_.mips, 0, desc_.layers}; }
    [[nodiscard]] VkImageView create_view(const ImagePart& part) const;
    const Device* device_ = nullptr;
    ImageDesc desc_;
    std::string name_;
    VkImage image_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    struct PartView {
        ImagePart part;
        VkImageView view;
    };
    mutable std::vector<PartView> part_views_; ///< those asked for so far
    VmaAllocation allocation_ = nullptr;       ///< null if the memory has another owner
    bool others_ = false;                      ///< the image has another owner
};

/// A block of device memory in which several transient images lie.
class MemoryBlock {
public:
    MemoryBlock() = default;
    MemoryBlock(const Device& device, const VkMemoryRequirements& requirements);
    ~MemoryBlock();
    MemoryBlock(MemoryBlock&& other) noexcept;
    MemoryBlock& operator=(MemoryBlock&& other) noexcept;

    [[nodiscard]] VmaAllocation handle() const { return allocation_; }

private:
    const Device* device_ = nullptr;
    VmaAllocation allocation_ = nullptr;
};

} // namespace atrium::gpu
