#pragma once
// Vector types and the few shapes that all parts share. Conventions: ARCHITECTURE.md.

#include <glm/glm.hpp>

#include <limits>

namespace atrium {

using glm::ivec2;
using glm::mat3;
using glm::mat4;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr float pi = 3.14159265358979323846f;

/// An axis-aligned box. Empty (min > max) until the first point is added.
struct Bounds {
    vec3 min{std::numeric_limits<float>::infinity()};
    vec3 max{-std::numeric_limits<float>::infinity()};

    void add(const vec3& p)
    {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    void add(const Bounds& b)
    {
        min = glm::min(min, b.min);
        max = glm::max(max, b.max);
    }
    [[nodiscard]] bool empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
    [[nodiscard]] vec3 centre() const { return empty() ? vec3(0) : 0.5f * (min + max); }
    [[nodiscard]] vec3 extent() const { return empty() ? vec3(0) : max - min; }
    [[nodiscard]] float diagonal() const { return glm::length(extent()); }
    /// Of the eight corners the n-th; bits 0, 1 and 2 choose the maximum of x, y and z. Not of empty bounds.
    [[nodiscard]] vec3 corner(unsigned n) const
    {
        return {(n & 1) != 0 ? max.x : min.x, (n & 2) != 0 ? max.y : min.y, (n & 4) != 0 ? max.z : min.z};
    }
};

/// Bounds of the eight corners after an affine transform; empty bounds stay empty.
[[nodiscard]] inline Bounds transformed(const Bounds& b, const mat4& m)
{
    Bounds out;
    for (unsigned n = 0; n < 8 && !b.empty(); ++n) out.add(vec3(m * vec4(b.corner(n), 1)));
    return out;
}

} // namespace atrium
