#pragma once
// The Vulkan instance, with validation when asked for, and the devices it finds.

#include "renderer/gpu/validation.hpp"

#include <vulkan/vulkan_core.h>

#include <memory>
#include <string>
#include <vector>

namespace atrium::gpu {

class Instance {
public:
    /// `extensions`: further ones, such as a window system wants. Throws Error(environment) when there is no loader or
    /// driver, or (validate) no validation layer.
    explicit Instance(bool validate, const std::vector<std::string>& extensions = {});
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    [[nodiscard]] VkInstance handle() const { return instance_; }
    [[nodiscard]] const ValidationLog& validation() const { return *log_; }
    [[nodiscard]] bool has_debug_utils() const { return debug_utils_; }

private:
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    std::unique_ptr<ValidationLog> log_ = std::make_unique<ValidationLog>();
    bool debug_utils_ = false;
};

/// What is optional: used where it helps, named where it is absent.
struct OptionalFeatures {
    bool host_memory_import = false; ///< VK_EXT_external_memory_host: scene upload straight from the mapped bake
    bool anisotropy = false;
    bool block_compression = false;
    bool geometry = false, tessellation = false; ///< stages of GraphicsPipelineDesc
    bool lines = false;                          ///< triangles drawn as lines: wireframes
    bool subgroup_ballot = false;                ///< in compute shaders: culling of single triangles
};

/// A device as `atrium devices` tells of it. Suitable when `refusals` is empty.
struct DeviceReport {
    std::string name, type, driver;
    std::uint32_t index = 0;
    std::vector<std::string> refusals;         ///< every reason, one line each
    std::vector<std::string> absent_optionals; ///< feature: what is done without it
    OptionalFeatures optional;
    bool is_cpu = false;
    std::uint32_t subgroup_size = 1;
    std::uint32_t subpixel_bits = 4; ///< of the positions that rasterisation rounds to
    std::uint32_t sample_counts =
        1; ///< bit mask of the sample counts (1, 2, 4…) that colour and depth targets can have
    std::uint32_t widest_image = 4096;
    std::uint64_t storage_range = 0; ///< bytes that one storage buffer binding reaches
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    std::uint32_t queue_family = 0; ///< graphics + compute + transfer
};

[[nodiscard]] std::vector<DeviceReport> list_devices(const Instance& instance);

/// The device called `wanted` (an index, or part of a name), or the best suitable one: discrete, integrated, virtual,
/// CPU. Throws Error(environment) that lists every device with its refusals; Error(usage) when `wanted` matches none.
[[nodiscard]] DeviceReport choose_device(const Instance& instance, const std::string& wanted);

} // namespace atrium::gpu
