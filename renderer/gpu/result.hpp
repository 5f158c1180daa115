#pragma once
// VkResult to Error.

#include <vulkan/vulkan_core.h>

#include <string_view>

namespace atrium::gpu {

/// Throws Error when `result` is a failure: environment for exhausted memory and lost devices, internal for the rest.
/// `doing` completes "could not …".
void check(VkResult result, std::string_view doing);

[[nodiscard]] const char* to_string(VkResult result);

} // namespace atrium::gpu
