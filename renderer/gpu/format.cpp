#include "renderer/gpu/format.hpp"

#include <stdexcept>

namespace atrium::gpu {

const char* to_string(Format f)
{
    switch (f) {
    case Format::none:
        return "none";
    case Format::r8_unorm:
        return "R8_UNORM";
    case Format::rg8_unorm:
        return "RG8_UNORM";
    case Format::rgba8_unorm:
        return "RGBA8_UNORM";
    case Format::rgba8_srgb:
        return "RGBA8_SRGB";
    case Format::bgra8_unorm:
        return "BGRA8_UNORM";
    case Format::r32_uint:
        return "R32_UINT";
    case Format::rg32_uint:
        return "RG32_UINT";
    case Format::r32_float:
        return "R32_FLOAT";
    case Format::rg32_float:
        return "RG32_FLOAT";
    case Format::rg16_float:
        return "RG16_FLOAT";
    case Format::rgba16_float:
        return "RGBA16_FLOAT";
    case Format::rgba32_float:
        return "RGBA32_FLOAT";
    case Format::depth32:
        return "D32";
    case Format::bc1_srgb:
        return "BC1_SRGB";
    case Format::bc3_srgb:
        return "BC3_SRGB";
    case Format::bc3_unorm:
        return "BC3_UNORM";
    case Format::bc5_unorm:
        return "BC5_UNORM";
    }
    return "?";
}

std::uint32_t bytes_per_texel(Format f)
{
    switch (f) {
    case Format::r8_unorm:
        return 1;
    case Format::rg8_unorm:
        return 2;
    case Format::rgba8_unorm:
    case Format::rgba8_srgb:
    case Format::r32_uint:
    case Format::r32_float:
    case Format::rg16_float:
    case Format::depth32:
        return 4;
    case Format::rg32_uint:
    case Format::rg32_float:
    case Format::rgba16_float:
        return 8;
    case Format::rgba32_float:
        return 16;
    default:
        throw std::logic_error("bytes_per_texel: no such size for this format");
    }
}

} // namespace atrium::gpu
