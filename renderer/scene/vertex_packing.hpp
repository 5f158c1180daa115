#pragma once
// Octahedral packing of the normals and tangents in Vertex. The same arithmetic stands in GLSL.
// Source: Meyer et al. 2010, "On Floating-Point Normal Vectors"; Cigolle et al. 2014, "A Survey of Efficient
// Representations for Independent Unit Vectors".

#include "renderer/core/math.hpp"

#include <cmath>
#include <cstdint>

namespace atrium {

inline constexpr float unorm16_max = 65535.0f;
inline constexpr float unorm15_max = 32767.0f;

/// +1 for zero, so that a fold never collapses onto an axis.
[[nodiscard]] inline float sign_not_zero(float x)
{
    return x >= 0.0f ? 1.0f : -1.0f;
}

/// Unit vector to the octahedron's square, each in -1..1. n must not be zero.
[[nodiscard]] inline vec2 octahedral_encode(const vec3& n)
{
    const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    const vec2 e = vec2(n.x, n.y) / sum;
    if (n.z >= 0.0f) return e;
    return {(1.0f - std::abs(e.y)) * sign_not_zero(e.x), (1.0f - std::abs(e.x)) * sign_not_zero(e.y)};
}

[[nodiscard]] inline vec3 octahedral_decode(const vec2& e)
{
    vec3 n(e.x, e.y, 1.0f - std::abs(e.x) - std::abs(e.y));
    if (n.z < 0.0f) {
        n.x = (1.0f - std::abs(e.y)) * sign_not_zero(e.x);
        n.y = (1.0f - std::abs(e.x)) * sign_not_zero(e.y);
    }
    return glm::normalize(n);
}

/// -1..1 to an unsigned code of 0..max, rounded to nearest.
[[nodiscard]] inline std::uint32_t pack_snorm_as_unorm(float x, float max)
{
    const float scaled = (x * 0.5f + 0.5f) * max + 0.5f;
    return static_cast<std::uint32_t>(glm::clamp(scaled, 0.0f, max));
}

[[nodiscard]] inline float unpack_snorm_from_unorm(std::uint32_t code, float max)
{
    return static_cast<float>(code) / max * 2.0f - 1.0f;
}

/// Vertex::normal: x in the low, y in the high 16 bits.
[[nodiscard]] inline std::uint32_t pack_normal(const vec3& n)
{
    const vec2 e = octahedral_encode(n);
    return pack_snorm_as_unorm(e.x, unorm16_max) | pack_snorm_as_unorm(e.y, unorm16_max) << 16;
}

[[nodiscard]] inline vec3 unpack_normal(std::uint32_t packed)
{
    return octahedral_decode(
        {unpack_snorm_from_unorm(packed & 0xffffu, unorm16_max), unpack_snorm_from_unorm(packed >> 16, unorm16_max)});
}

/// Vertex::tangent: x in 16 bits, y in 15, bit 31 set when the handedness is -1.
[[nodiscard]] inline std::uint32_t pack_tangent(const vec3& t, float handedness)
{
    const vec2 e = octahedral_encode(t);
    return pack_snorm_as_unorm(e.x, unorm16_max) | pack_snorm_as_unorm(e.y, unorm15_max) << 16 |
           (handedness < 0.0f ? 1u << 31 : 0u);
}

/// xyz: unit tangent; w: handedness, +1 or -1.
[[nodiscard]] inline vec4 unpack_tangent(std::uint32_t packed)
{
    const vec3 t = octahedral_decode({unpack_snorm_from_unorm(packed & 0xffffu, unorm16_max),
                                      unpack_snorm_from_unorm(packed >> 16 & 0x7fffu, unorm15_max)});
    return {t, (packed >> 31) != 0 ? -1.0f : 1.0f};
}

} // namespace atrium
