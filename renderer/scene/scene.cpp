#include "renderer/scene/scene.hpp"

#include <algorithm>

namespace atrium {
namespace {

std::uint64_t round_up(std::uint64_t value, std::uint64_t multiple)
{
    return (value + multiple - 1) / multiple * multiple;
}

/// Bytes of a texel, or of a block of 4x4 texels.
std::uint64_t unit_bytes(TextureFormat f)
{
    switch (f) {
    case TextureFormat::rgba8_srgb:
    case TextureFormat::rgba8_unorm:
        return 4;
    case TextureFormat::rg8_unorm:
        return 2;
    case TextureFormat::r8_unorm:
        return 1;
    case TextureFormat::bc1_srgb:
        return 8;
    case TextureFormat::bc3_srgb:
    case TextureFormat::bc3_unorm:
    case TextureFormat::bc5_unorm:
        return 16;
    }
    return 0;
}

} // namespace

const char* to_string(MaterialClass c)
{
    switch (c) {
    case MaterialClass::opaque:
        return "opaque";
    case MaterialClass::masked:
        return "masked";
    case MaterialClass::blended:
        return "blended";
    case MaterialClass::cloth:
        return "cloth";
    }
    return "?";
}

const char* to_string(TextureFormat f)
{
    switch (f) {
    case TextureFormat::rgba8_srgb:
        return "rgba8_srgb";
    case TextureFormat::rgba8_unorm:
        return "rgba8_unorm";
    case TextureFormat::rg8_unorm:
        return "rg8_unorm";
    case TextureFormat::r8_unorm:
        return "r8_unorm";
    case TextureFormat::bc1_srgb:
        return "bc1_srgb";
    case TextureFormat::bc3_srgb:
        return "bc3_srgb";
    case TextureFormat::bc3_unorm:
        return "bc3_unorm";
    case TextureFormat::bc5_unorm:
        return "bc5_unorm";
    }
    return "?";
}

bool is_block_compressed(TextureFormat f)
{
    return f >= TextureFormat::bc1_srgb;
}

std::uint64_t mip_bytes(TextureFormat f, std::uint32_t width, std::uint32_t height)
{
    const std::uint64_t side = is_block_compressed(f) ? 4 : 1;
    return round_up(width, side) / side * (round_up(height, side) / side) * unit_bytes(f);
}

std::vector<std::uint64_t> mip_offsets(TextureFormat f, std::uint32_t width, std::uint32_t height, std::uint32_t mips)
{
    std::vector<std::uint64_t> offsets{0};
    for (std::uint32_t i = 0; i < std::min(mips, 32u); ++i) {
        const std::uint64_t bytes = mip_bytes(f, std::max(1u, width >> i), std::max(1u, height >> i));
        offsets.push_back(offsets.back() + round_up(bytes, texel_alignment));
    }
    return offsets;
}

} // namespace atrium
