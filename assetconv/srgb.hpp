#pragma once
// sRGB, exactly rounded and fast enough for whole mip chains. Source: IEC 61966-2-1.

#include <array>
#include <cmath>
#include <cstdint>

namespace atrium {

[[nodiscard]] inline float srgb_decode(float encoded)
{
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

[[nodiscard]] inline float srgb_encode(float linear)
{
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// Linear value of an 8-bit code.
[[nodiscard]] const std::array<float, 256>& srgb_decode_table();

/// Nearest 8-bit code of a linear value of 0..1 (clamped).
[[nodiscard]] std::uint8_t srgb_encode8(float linear);

} // namespace atrium
