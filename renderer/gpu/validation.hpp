#pragma once
// Khronos validation: what it said, and how often.

#include <vulkan/vulkan_core.h>

#include <mutex>
#include <string>
#include <vector>

namespace atrium::gpu {

/// Collects the messages of the validation layer (warnings and errors; core and synchronisation checks).
/// Thread-safe; lives at least as long as the instance it listens to.
class ValidationLog {
public:
    void add(std::string message);
    [[nodiscard]] std::size_t count() const;
    [[nodiscard]] std::vector<std::string> messages() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::string> messages_;
};

/// Name of the layer, and of the Debian package that brings it.
inline constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";
inline constexpr const char* validation_package = "vulkan-validationlayers";

} // namespace atrium::gpu
