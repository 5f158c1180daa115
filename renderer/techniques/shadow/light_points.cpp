#include "renderer/techniques/shadow/light_points.hpp"

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double turn = 6.28318530717958647693;

/// The n-th point of an additive sequence in the unit square or cube, steps being powers of one over the number that
/// solves x^(d+1) = x + 1.
double fraction(double step, std::uint32_t n)
{
    const double x = 0.5 + step * n;
    return x - std::floor(x);
}

dvec2 in_square(std::uint32_t n)
{
    constexpr double g = 1.32471795724474602596;
    return {fraction(1 / g, n), fraction(1 / (g * g), n)};
}

dvec3 in_cube(std::uint32_t n)
{
    constexpr double g = 1.22074408460575947536;
    return {fraction(1 / g, n), fraction(1 / (g * g), n), fraction(1 / (g * g * g), n)};
}

dvec2 on_disc(const dvec2& square)
{
    const dvec2 s = 2.0 * square - 1.0;
    if (s.x == 0 && s.y == 0) return {0, 0};
    const bool wide = std::abs(s.x) > std::abs(s.y);
    const double r = wide ? s.x : s.y;
    const double angle = wide ? turn / 8 * (s.y / s.x) : turn / 4 - turn / 8 * (s.x / s.y);
    return {r * std::cos(angle), r * std::sin(angle)};
}

/// In the unit ball, so that on any plane the projections are uniform in the unit disc: points of the sphere in four
/// dimensions, one coordinate left out.
dvec3 in_ball(const dvec3& cube)
{
    const double a = std::sqrt(1 - cube.x), b = std::sqrt(cube.x);
    return {a * std::sin(turn * cube.y), a * std::cos(turn * cube.y), b * std::sin(turn * cube.z)};
}

} // namespace

float light_extent(const Light& light, float softness)
{
    switch (light.type) {
    case LightType::sun:
        return softness * std::tan(glm::radians(0.5f * light.angle));
    case LightType::rect:
        return softness * 0.5f * glm::length(vec2(light.width, light.height));
    default:
        return softness * light.size;
    }
}

Light at_point(const Light& light, float softness, std::uint32_t n)
{
    Light out = light;
    const LightAxes axes = axes_of(light);
    if (light.type == LightType::rect) {
        const vec2 at = vec2(2.0 * in_square(n) - 1.0) * (0.5f * softness);
        out.position += axes.right * (at.x * light.width) + axes.up * (at.y * light.height);
        return out;
    }
    if (light.type == LightType::sun) {
        const vec2 at = vec2(on_disc(in_square(n))) * light_extent(light, softness);
        out.direction = axes.direction + axes.right * at.x + axes.up * at.y;
        return out;
    }
    out.position += vec3(in_ball(in_cube(n))) * light_extent(light, softness);
    return out;
}

} // namespace atrium
