#pragma once
// The formats that passes use, under the names the documents use.

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace atrium::gpu {

enum class Format : std::uint32_t {
    none = VK_FORMAT_UNDEFINED,
    r8_unorm = VK_FORMAT_R8_UNORM,
    rg8_unorm = VK_FORMAT_R8G8_UNORM,
    rgba8_unorm = VK_FORMAT_R8G8B8A8_UNORM,
    rgba8_srgb = VK_FORMAT_R8G8B8A8_SRGB,
    bgra8_unorm = VK_FORMAT_B8G8R8A8_UNORM,
    r32_uint = VK_FORMAT_R32_UINT,
    rg32_uint = VK_FORMAT_R32G32_UINT,
    r32_float = VK_FORMAT_R32_SFLOAT,
    rg32_float = VK_FORMAT_R32G32_SFLOAT,
    rg16_float = VK_FORMAT_R16G16_SFLOAT,
    rgba16_float = VK_FORMAT_R16G16B16A16_SFLOAT,
    rgba32_float = VK_FORMAT_R32G32B32A32_SFLOAT,
    depth32 = VK_FORMAT_D32_SFLOAT,
    bc1_srgb = VK_FORMAT_BC1_RGBA_SRGB_BLOCK,
    bc3_srgb = VK_FORMAT_BC3_SRGB_BLOCK,
    bc3_unorm = VK_FORMAT_BC3_UNORM_BLOCK,
    bc5_unorm = VK_FORMAT_BC5_UNORM_BLOCK,
};

[[nodiscard]] inline VkFormat vk(Format f)
{
    return static_cast<VkFormat>(f);
}
[[nodiscard]] const char* to_string(Format f);
[[nodiscard]] std::uint32_t bytes_per_texel(Format f); ///< uncompressed formats only
[[nodiscard]] inline bool is_depth(Format f)
{
    return f == Format::depth32;
}

} // namespace atrium::gpu
