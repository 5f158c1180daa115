#include "renderer/gpu/resources.hpp"

#include "renderer/gpu/memory.hpp"
#include "renderer/gpu/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace atrium::gpu {

Buffer::Buffer(const Device& device, std::string_view name, std::uint64_t size, VkBufferUsageFlags usage, MemoryUse use)
    : device_(&device), size_(size)
{
    VkBufferCreateInfo create{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    create.size = size;
    create.usage = usage;
    VmaAllocationCreateInfo allocate{};
    allocate.usage = use == MemoryUse::device ? VMA_MEMORY_USAGE_AUTO_PREFER_DEVICE : VMA_MEMORY_USAGE_AUTO;
    allocate.flags = VMA_ALLOCATION_CREATE_MAPPED_BIT;
    switch (use) {
    case MemoryUse::device:
        allocate.flags |= VMA_ALLOCATION_CREATE_HOST_ACCESS_SEQUENTIAL_WRITE_BIT |
                          VMA_ALLOCATION_CREATE_HOST_ACCESS_ALLOW_TRANSFER_INSTEAD_BIT;
        break;
    case MemoryUse::upload:
        allocate.flags |= VMA_ALLOCATION_CREATE_HOST_ACCESS_SEQUENTIAL_WRITE_BIT;
        break;
    case MemoryUse::readback:
        allocate.flags |= VMA_ALLOCATION_CREATE_HOST_ACCESS_RANDOM_BIT;
        break;
    }
    VmaAllocationInfo info{};
    check(vmaCreateBuffer(device.allocator(), &create, &allocate, &buffer_, &allocation_, &info),
          fmt::format("allocate {} bytes for buffer {}", size, name));
    mapped_ = info.pMappedData;
    device.name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<std::uint64_t>(buffer_), name);
}

Buffer::~Buffer()
{
    if (buffer_) vmaDestroyBuffer(device_->allocator(), buffer_, allocation_);
}

Buffer::Buffer(Buffer&& other) noexcept
{
    *this = std::move(other);
}

Buffer& Buffer::operator=(Buffer&& other) noexcept
{
    std::swap(device_, other.device_);
    std::swap(buffer_, other.buffer_);
    std::swap(allocation_, other.allocation_);
    std::swap(mapped_, other.mapped_);
    std::swap(size_, other.size_);
    return *this;
}

void Buffer::write(std::span<const std::byte> bytes) const
{
    std::copy(bytes.begin(), bytes.end(), mapped().begin());
    flush();
}

void Buffer::flush() const
{
    vmaFlushAllocation(device_->allocator(), allocation_, 0, VK_WHOLE_SIZE);
}
void Buffer::invalidate() const
{
    vmaInvalidateAllocation(device_->allocator(), allocation_, 0, VK_WHOLE_SIZE);
}

namespace {

VkImageCreateInfo image_create_info(const ImageDesc& desc)
{
    VkImageCreateInfo create{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    create.imageType = VK_IMAGE_TYPE_2D;
    create.format = vk(desc.format);
    create.extent = {desc.width, desc.height, 1};
    create.mipLevels = desc.mips;
    create.arrayLayers = desc.layers;
    create.samples = static_cast<VkSampleCountFlagBits>(desc.samples);
    create.tiling = VK_IMAGE_TILING_OPTIMAL;
    create.usage = desc.usage;
    return create;
}

} // namespace

Image::Image(const Device& device, std::string_view name, const ImageDesc& desc)
    : device_(&device), desc_(desc), name_(name)
{
    const VkImageCreateInfo create = image_create_info(desc);
    VmaAllocationCreateInfo allocate{};
    allocate.usage = VMA_MEMORY_USAGE_AUTO_PREFER_DEVICE;
    check(vmaCreateImage(device.allocator(), &create, &allocate, &image_, &allocation_, nullptr),
          fmt::format("allocate image {} ({}x{} {})", name, desc.width, desc.height, to_string(desc.format)));
    device.name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(image_), name);
    view_ = create_view(whole());
}

Image Image::create_unbound(const Device& device, std::string_view name, const ImageDesc& desc)
{
    Image image;
    image.device_ = &device;
    image.desc_ = desc;
    image.name_ = name;
    const VkImageCreateInfo create = image_create_info(desc);
    check(vkCreateImage(device.handle(), &create, nullptr, &image.image_), fmt::format("create image {}", name));
    device.name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(image.image_), name);
    return image;
}

Image Image::of_others(const Device& device, std::string_view name, const ImageDesc& desc, VkImage handle)
{
    Image image;
    image.device_ = &device;
    image.desc_ = desc;
    image.name_ = name;
    image.image_ = handle;
    image.others_ = true;
    device.name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(handle), name);
    image.view_ = image.create_view(image.whole());
    return image;
}

VkMemoryRequirements Image::requirements() const
{
    VkMemoryRequirements requirements{};
    vkGetImageMemoryRequirements(device_->handle(), image_, &requirements);
    return requirements;
}

void Image::bind(VmaAllocation block, std::uint64_t offset)
{
    check(vmaBindImageMemory2(device_->allocator(), block, offset, image_, nullptr),
          fmt::format("place image {}", name_));
    view_ = create_view(whole());
}

VkImageView Image::view(const ImagePart& part) const
{
    if (part == whole()) return view_;
    for (const PartView& known : part_views_) {
        if (known.part == part) return known.view;
    }
    part_views_.push_back({part, create_view(part)});
    return part_views_.back().view;
}

VkImageView Image::create_view(const ImagePart& part) const
{
    // Vulkan allows no view of an image that is only copied.
    constexpr VkImageUsageFlags copies = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if ((desc_.usage & ~copies) == 0 && !others_) return VK_NULL_HANDLE;
    VkImageViewCreateInfo create{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    create.image = image_;
    create.viewType = part.layers > 1 || part.array ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
    create.format = vk(desc_.format);
    create.subresourceRange.aspectMask = is_depth(desc_.format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
    create.subresourceRange.baseMipLevel = part.first_mip;
    create.subresourceRange.levelCount = part.mips;
    create.subresourceRange.baseArrayLayer = part.first_layer;
    create.subresourceRange.layerCount = part.layers;
    VkImageView view = VK_NULL_HANDLE;
    check(vkCreateImageView(device_->handle(), &create, nullptr, &view),
          fmt::format("create a view of image {}", name_));
    device_->name(VK_OBJECT_TYPE_IMAGE_VIEW, reinterpret_cast<std::uint64_t>(view), name_);
    return view;
}

Image::~Image()
{
    if (!device_) return;
    if (view_) vkDestroyImageView(device_->handle(), view_, nullptr);
    for (const PartView& part : part_views_) vkDestroyImageView(device_->handle(), part.view, nullptr);
    if (others_) return;
    if (allocation_) {
        vmaDestroyImage(device_->allocator(), image_, allocation_);
    } else if (image_) {
        vkDestroyImage(device_->handle(), image_, nullptr);
    }
}

Image::Image(Image&& other) noexcept
{
    *this = std::move(other);
}

Image& Image::operator=(Image&& other) noexcept
{
    std::swap(device_, other.device_);
    std::swap(desc_, other.desc_);
    std::swap(name_, other.name_);
    std::swap(image_, other.image_);
    std::swap(view_, other.view_);
    std::swap(part_views_, other.part_views_);
    std::swap(allocation_, other.allocation_);
    std::swap(others_, other.others_);
    return *this;
}

MemoryBlock::MemoryBlock(const Device& device, const VkMemoryRequirements& requirements) : device_(&device)
{
    VmaAllocationCreateInfo allocate{};
    allocate.preferredFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    allocate.flags = VMA_ALLOCATION_CREATE_CAN_ALIAS_BIT;
    check(vmaAllocateMemory(device.allocator(), &requirements, &allocate, &allocation_, nullptr),
          fmt::format("allocate {} bytes for transient images", requirements.size));
}

MemoryBlock::~MemoryBlock()
{
    if (allocation_) vmaFreeMemory(device_->allocator(), allocation_);
}

MemoryBlock::MemoryBlock(MemoryBlock&& other) noexcept
{
    *this = std::move(other);
}

MemoryBlock& MemoryBlock::operator=(MemoryBlock&& other) noexcept
{
    std::swap(device_, other.device_);
    std::swap(allocation_, other.allocation_);
    return *this;
}

} // namespace atrium::gpu
