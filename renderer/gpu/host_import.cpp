#include "renderer/gpu/host_import.hpp"

#include <bit>
#include <cstdint>
#include <utility>

namespace atrium::gpu {

std::optional<HostImport> HostImport::create(const Device& device, std::span<const std::byte> memory)
{
    const std::uint64_t alignment = device.import_alignment();
    if (alignment == 0 || memory.empty() || reinterpret_cast<std::uintptr_t>(memory.data()) % alignment != 0)
        return std::nullopt;
    const std::uint64_t size = (memory.size() + alignment - 1) / alignment * alignment;
    void* pointer = const_cast<std::byte*>(memory.data()); // only ever read: TRANSFER_SRC

    const auto properties_of = reinterpret_cast<PFN_vkGetMemoryHostPointerPropertiesEXT>(
        vkGetDeviceProcAddr(device.handle(), "vkGetMemoryHostPointerPropertiesEXT"));
    constexpr auto handle_type = VK_EXTERNAL_MEMORY_HANDLE_TYPE_HOST_ALLOCATION_BIT_EXT;
    VkMemoryHostPointerPropertiesEXT properties{VK_STRUCTURE_TYPE_MEMORY_HOST_POINTER_PROPERTIES_EXT};
    if (!properties_of || properties_of(device.handle(), handle_type, pointer, &properties) != VK_SUCCESS)
        return std::nullopt;

    HostImport import(device);
    VkExternalMemoryBufferCreateInfo external{VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_BUFFER_CREATE_INFO};
    external.handleTypes = handle_type;
    VkBufferCreateInfo create{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    create.pNext = &external;
    create.size = size;
    create.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    if (vkCreateBuffer(device.handle(), &create, nullptr, &import.buffer_) != VK_SUCCESS) return std::nullopt;

    VkMemoryRequirements requirements{};
    vkGetBufferMemoryRequirements(device.handle(), import.buffer_, &requirements);
    const std::uint32_t types = requirements.memoryTypeBits & properties.memoryTypeBits;
    if (types == 0 || requirements.size > size) return std::nullopt;

    VkImportMemoryHostPointerInfoEXT from{VK_STRUCTURE_TYPE_IMPORT_MEMORY_HOST_POINTER_INFO_EXT};
    from.handleType = handle_type;
    from.pHostPointer = pointer;
    VkMemoryAllocateInfo allocate{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    allocate.pNext = &from;
    allocate.allocationSize = size;
    allocate.memoryTypeIndex = static_cast<std::uint32_t>(std::countr_zero(types));
    if (vkAllocateMemory(device.handle(), &allocate, nullptr, &import.memory_) != VK_SUCCESS) return std::nullopt;
    if (vkBindBufferMemory(device.handle(), import.buffer_, import.memory_, 0) != VK_SUCCESS) return std::nullopt;
    return import;
}

HostImport::~HostImport()
{
    vkDestroyBuffer(device_.handle(), buffer_, nullptr);
    vkFreeMemory(device_.handle(), memory_, nullptr);
}

HostImport::HostImport(HostImport&& other) noexcept
    : device_(other.device_), buffer_(std::exchange(other.buffer_, VK_NULL_HANDLE)),
      memory_(std::exchange(other.memory_, VK_NULL_HANDLE))
{}

} // namespace atrium::gpu
