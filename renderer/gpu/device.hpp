#pragma once
// The logical device with its one queue, memory allocator and debug names.

#include "renderer/gpu/instance.hpp"

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

struct VmaAllocator_T;
using VmaAllocator = VmaAllocator_T*;

namespace atrium::gpu {

/// Semaphores around a submission: what it waits for and what it signals. Null: none.
struct SubmitSync {
    VkSemaphore wait = VK_NULL_HANDLE, signal = VK_NULL_HANDLE;
};

struct HeapUse {
    bool device_local = false;
    std::uint64_t bytes = 0;  ///< allocated by this process
    std::uint64_t budget = 0; ///< what the driver would let it have
};

class Device {
public:
    /// `presents`: to windows. Throws Error(environment) where the device cannot.
    Device(const Instance& instance, const DeviceReport& report, bool presents = false);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] VkDevice handle() const { return device_; }
    [[nodiscard]] VkPhysicalDevice physical() const { return report_.handle; }
    [[nodiscard]] VkQueue queue() const { return queue_; }
    [[nodiscard]] VmaAllocator allocator() const { return allocator_; }
    [[nodiscard]] const DeviceReport& report() const { return report_; }
    [[nodiscard]] const ValidationLog& validation() const { return instance_.validation(); }
    [[nodiscard]] float timestamp_period() const { return timestamp_period_; } ///< ns per tick
    [[nodiscard]] float max_anisotropy() const { return max_anisotropy_; }
    [[nodiscard]] std::uint64_t import_alignment() const { return import_alignment_; } ///< 0: no import of host memory

    /// Names an object in captures and validation messages.
    void name(VkObjectType type, std::uint64_t handle, std::string_view text) const;
    void begin_label(VkCommandBuffer cmd, std::string_view text) const;
    void end_label(VkCommandBuffer cmd) const;

    /// Records into a fresh command buffer, submits it and waits until the device is done.
    void run(const std::function<void(VkCommandBuffer)>& record) const;
    /// The two halves of run(), for measuring and for work between them. One submission at a time.
    void submit(const std::function<void(VkCommandBuffer)>& record, const SubmitSync& sync = {}) const;
    void wait() const;

    /// Bytes of device memory that this process has allocated, by heap.
    [[nodiscard]] std::vector<HeapUse> memory_by_heap() const;
    /// Of all heaps.
    [[nodiscard]] std::uint64_t memory_in_use() const;

private:
    const Instance& instance_;
    DeviceReport report_;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    VmaAllocator allocator_ = nullptr;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    float timestamp_period_ = 1;
    float max_anisotropy_ = 1;
    std::uint64_t import_alignment_ = 0;
    PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
};

} // namespace atrium::gpu
