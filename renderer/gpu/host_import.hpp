#pragma once
// Host memory, such as a mapped file, as the source of device copies (VK_EXT_external_memory_host).

#include "renderer/gpu/device.hpp"

#include <optional>
#include <span>

namespace atrium::gpu {

class HostImport {
public:
    /// `memory` begins at a multiple of Device::import_alignment(); its last page counts as whole. Nothing is copied,
    /// and the memory must outlive the object. Empty when the driver refuses.
    [[nodiscard]] static std::optional<HostImport> create(const Device& device, std::span<const std::byte> memory);
    ~HostImport();
    HostImport(HostImport&& other) noexcept;
    HostImport& operator=(HostImport&&) = delete;

    [[nodiscard]] VkBuffer buffer() const { return buffer_; } ///< transfer source

private:
    explicit HostImport(const Device& device) : device_(device) {}
    const Device& device_;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

} // namespace atrium::gpu
