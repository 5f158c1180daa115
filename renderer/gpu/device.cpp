#include "renderer/gpu/device.hpp"

#include "renderer/gpu/memory.hpp"
#include "renderer/gpu/result.hpp"

#include <array>
#include <string>
#include <vector>

namespace atrium::gpu {
namespace {

template <class F>
F device_function(VkDevice device, const char* name)
{
    return reinterpret_cast<F>(vkGetDeviceProcAddr(device, name));
}

VkDevice create_device(const DeviceReport& report, bool presents)
{
    VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    v13.dynamicRendering = VK_TRUE;
    v13.maintenance4 = VK_TRUE;
    v13.synchronization2 = VK_TRUE;
    VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    v12.pNext = &v13;
    v12.drawIndirectCount = VK_TRUE;
    v12.descriptorIndexing = VK_TRUE;
    v12.runtimeDescriptorArray = VK_TRUE;
    v12.descriptorBindingPartiallyBound = VK_TRUE;
    v12.descriptorBindingSampledImageUpdateAfterBind = VK_TRUE;
    v12.shaderSampledImageArrayNonUniformIndexing = VK_TRUE;
    v12.scalarBlockLayout = VK_TRUE;
    v12.hostQueryReset = VK_TRUE;
    VkPhysicalDeviceVulkan11Features v11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
    v11.pNext = &v12;
    v11.shaderDrawParameters = VK_TRUE;
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    features.pNext = &v11;
    features.features.robustBufferAccess = VK_TRUE;
    features.features.multiDrawIndirect = VK_TRUE;
    features.features.drawIndirectFirstInstance = VK_TRUE;
    features.features.geometryShader = report.optional.geometry;
    features.features.tessellationShader = report.optional.tessellation;
    features.features.independentBlend = VK_TRUE;
    features.features.samplerAnisotropy = report.optional.anisotropy;
    features.features.textureCompressionBC = report.optional.block_compression;
    features.features.fillModeNonSolid = report.optional.lines;

    std::vector<const char*> extensions;
    if (report.optional.host_memory_import) extensions.push_back(VK_EXT_EXTERNAL_MEMORY_HOST_EXTENSION_NAME);

    if (presents) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);

    const float priority = 1;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueFamilyIndex = report.queue_family;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;

    VkDeviceCreateInfo create{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    create.pNext = &features;
    create.queueCreateInfoCount = 1;
    create.pQueueCreateInfos = &queue;
    create.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    create.ppEnabledExtensionNames = extensions.data();
    VkDevice device = VK_NULL_HANDLE;
    check(vkCreateDevice(report.handle, &create, nullptr, &device), "create the Vulkan device");
    return device;
}

} // namespace

Device::Device(const Instance& instance, const DeviceReport& report, bool presents)
    : instance_(instance), report_(report), device_(create_device(report, presents))
{
    vkGetDeviceQueue(device_, report.queue_family, 0, &queue_);

    VkPhysicalDeviceExternalMemoryHostPropertiesEXT import{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTERNAL_MEMORY_HOST_PROPERTIES_EXT};
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    if (report.optional.host_memory_import) properties.pNext = &import;
    vkGetPhysicalDeviceProperties2(report.handle, &properties);
    timestamp_period_ = properties.properties.limits.timestampPeriod;
    max_anisotropy_ = report.optional.anisotropy ? properties.properties.limits.maxSamplerAnisotropy : 1;
    if (report.optional.host_memory_import) import_alignment_ = import.minImportedHostPointerAlignment;

    if (instance.has_debug_utils()) {
        set_name_ = device_function<PFN_vkSetDebugUtilsObjectNameEXT>(device_, "vkSetDebugUtilsObjectNameEXT");
        begin_label_ = device_function<PFN_vkCmdBeginDebugUtilsLabelEXT>(device_, "vkCmdBeginDebugUtilsLabelEXT");
        end_label_ = device_function<PFN_vkCmdEndDebugUtilsLabelEXT>(device_, "vkCmdEndDebugUtilsLabelEXT");
    }

    VmaAllocatorCreateInfo allocator{};
    allocator.physicalDevice = report.handle;
    allocator.device = device_;
    allocator.instance = instance.handle();
    allocator.vulkanApiVersion = VK_API_VERSION_1_3;
    check(vmaCreateAllocator(&allocator, &allocator_), "create the memory allocator");

    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.queueFamilyIndex = report.queue_family;
    check(vkCreateCommandPool(device_, &pool, nullptr, &pool_), "create a command pool");
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool_;
    allocate.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(device_, &allocate, &commands_), "allocate a command buffer");
    VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    check(vkCreateFence(device_, &fence, nullptr, &fence_), "create a fence");
}

Device::~Device()
{
    vkDeviceWaitIdle(device_);
    vkDestroyFence(device_, fence_, nullptr);
    vkDestroyCommandPool(device_, pool_, nullptr);
    vmaDestroyAllocator(allocator_);
    vkDestroyDevice(device_, nullptr);
}

void Device::name(VkObjectType type, std::uint64_t handle, std::string_view text) const
{
    if (!set_name_) return;
    const std::string terminated(text);
    VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = terminated.c_str();
    set_name_(device_, &info);
}

void Device::begin_label(VkCommandBuffer cmd, std::string_view text) const
{
    if (!begin_label_) return;
    const std::string terminated(text);
    VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
    label.pLabelName = terminated.c_str();
    begin_label_(cmd, &label);
}

void Device::end_label(VkCommandBuffer cmd) const
{
    if (end_label_) end_label_(cmd);
}

void Device::submit(const std::function<void(VkCommandBuffer)>& record, const SubmitSync& sync) const
{
    check(vkResetCommandPool(device_, pool_, 0), "reset the command pool");
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands_, &begin), "begin recording");
    record(commands_);
    check(vkEndCommandBuffer(commands_), "record commands");

    VkCommandBufferSubmitInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    commands.commandBuffer = commands_;
    VkSubmitInfo2 submit_info{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit_info.commandBufferInfoCount = 1;
    submit_info.pCommandBufferInfos = &commands;
    VkSemaphoreSubmitInfo wait{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO}, signal = wait;
    wait.semaphore = sync.wait;
    signal.semaphore = sync.signal;
    wait.stageMask = signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    submit_info.waitSemaphoreInfoCount = sync.wait ? 1 : 0;
    submit_info.pWaitSemaphoreInfos = &wait;
    submit_info.signalSemaphoreInfoCount = sync.signal ? 1 : 0;
    submit_info.pSignalSemaphoreInfos = &signal;
    check(vkQueueSubmit2(queue_, 1, &submit_info, fence_), "submit commands");
}

void Device::wait() const
{
    check(vkWaitForFences(device_, 1, &fence_, VK_TRUE, UINT64_MAX), "wait for the device");
    check(vkResetFences(device_, 1, &fence_), "reset a fence");
}

void Device::run(const std::function<void(VkCommandBuffer)>& record) const
{
    submit(record);
    wait();
}

std::vector<HeapUse> Device::memory_by_heap() const
{
    std::array<VmaBudget, VK_MAX_MEMORY_HEAPS> budgets{};
    vmaGetHeapBudgets(allocator_, budgets.data());
    VkPhysicalDeviceMemoryProperties properties{};
    vkGetPhysicalDeviceMemoryProperties(report_.handle, &properties);
    std::vector<HeapUse> heaps;
    for (std::uint32_t i = 0; i < properties.memoryHeapCount; ++i) {
        const VkMemoryHeap& heap = properties.memoryHeaps[i];
        heaps.push_back({(heap.flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0, budgets[i].statistics.allocationBytes,
                         budgets[i].budget});
    }
    return heaps;
}

std::uint64_t Device::memory_in_use() const
{
    std::uint64_t bytes = 0;
    for (const HeapUse& heap : memory_by_heap()) bytes += heap.bytes;
    return bytes;
}

} // namespace atrium::gpu
