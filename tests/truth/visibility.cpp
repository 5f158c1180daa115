#include "tests/truth/visibility.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::truth {
namespace {

constexpr double pi_d = 3.14159265358979323846;
constexpr double light_end = 1 - 1e-4; ///< stop short of the light: its own surface may be in the scene

/// A bijection of 64 bits that looks random. Source: Steele et al. 2014, SplitMix.
std::uint64_t scramble(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

double unit_random(std::uint64_t x)
{
    return static_cast<double>(scramble(x) >> 11) * 0x1p-53;
}

/// Mean of f over the unit square, one sample in each cell of a square grid.
template <class F>
double stratified_mean(const Sampling& sampling, F f)
{
    const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(sampling.count))));
    const std::uint64_t stream = scramble(sampling.seed);
    double sum = 0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::uint64_t cell = stream + 2 * (static_cast<std::uint64_t>(j) * static_cast<std::uint64_t>(side) +
                                                     static_cast<std::uint64_t>(i));
            sum += f(dvec2((i + unit_random(cell)) / side, (j + unit_random(cell + 1)) / side));
        }
    }
    return sum / (static_cast<double>(side) * side);
}

/// Square to unit disc, areas kept. Source: Shirley & Chiu 1997, concentric map.
dvec2 on_disc(const dvec2& square)
{
    const dvec2 s = 2.0 * square - 1.0;
    if (s.x == 0 && s.y == 0) return {0, 0};
    const bool wide = std::abs(s.x) > std::abs(s.y);
    const double r = wide ? s.x : s.y;
    const double phi = wide ? pi_d / 4 * (s.y / s.x) : pi_d / 2 - pi_d / 4 * (s.x / s.y);
    return {r * std::cos(phi), r * std::sin(phi)};
}

struct Frame {
    dvec3 u, v;
};

/// Two unit vectors at right angles to the unit vector n.
Frame frame_around(const dvec3& n)
{
    const dvec3 u = glm::normalize(glm::cross(std::abs(n.x) > 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), n));
    return {u, glm::cross(n, u)};
}

dvec3 origin_of(const Surfel& s)
{
    const dvec3 p = glm::abs(s.position);
    return s.position + s.normal * (1e-4 * std::max({1.0, p.x, p.y, p.z}));
}

dvec3 point_on(const AreaLight& light, const dvec2& square)
{
    const dvec2 s = light.disc ? on_disc(square) : 2.0 * square - 1.0;
    return light.centre + s.x * light.half_u + s.y * light.half_v;
}

double seen(const TruthScene& scene, const dvec3& from, const dvec3& point)
{
    return scene.occluded({from, point - from, 0, light_end}) ? 0 : 1;
}

} // namespace

AreaLight disc_towards(const dvec3& from, const dvec3& centre, double radius)
{
    const Frame frame = frame_around(glm::normalize(from - centre));
    return {centre, radius * frame.u, radius * frame.v, true};
}

double point_visibility(const TruthScene& scene, const Surfel& at, const dvec3& light)
{
    return seen(scene, origin_of(at), light);
}

double area_visibility(const TruthScene& scene, const Surfel& at, const AreaLight& light, const Sampling& sampling)
{
    const dvec3 from = origin_of(at);
    return stratified_mean(sampling, [&](const dvec2& s) { return seen(scene, from, point_on(light, s)); });
}

double sun_visibility(const TruthScene& scene, const Surfel& at, const dvec3& travel, double angle,
                      const Sampling& sampling)
{
    const dvec3 from = origin_of(at), to_sun = -glm::normalize(travel);
    const Frame frame = frame_around(to_sun);
    const double radius = std::tan(angle / 2 * pi_d / 180);
    return stratified_mean(sampling, [&](const dvec2& s) {
        const dvec2 d = radius * on_disc(s);
        return scene.occluded({from, to_sun + d.x * frame.u + d.y * frame.v}) ? 0.0 : 1.0;
    });
}

double area_illuminance(const TruthScene& scene, const Surfel& at, const AreaLight& light, const Sampling& sampling)
{
    const dvec3 from = origin_of(at), plane = glm::cross(light.half_u, light.half_v);
    const dvec3 facing = glm::normalize(plane);
    const double area = (light.disc ? pi_d : 4.0) * glm::length(plane);
    return area * stratified_mean(sampling, [&](const dvec2& s) {
               const dvec3 point = point_on(light, s), to = point - at.position;
               const double d2 = glm::dot(to, to);
               const double cosines = std::max(0.0, glm::dot(at.normal, to)) * std::max(0.0, -glm::dot(facing, to));
               return cosines > 0 ? seen(scene, from, point) * cosines / (d2 * d2) : 0.0;
           });
}

double ambient_visibility(const TruthScene& scene, const Surfel& at, double radius, const Sampling& sampling)
{
    const dvec3 from = origin_of(at);
    const Frame frame = frame_around(at.normal);
    return stratified_mean(sampling, [&](const dvec2& s) {
        const dvec2 d = on_disc(s);
        const double up = std::sqrt(std::max(0.0, 1 - glm::dot(d, d)));
        return scene.occluded({from, d.x * frame.u + d.y * frame.v + up * at.normal, 0, radius}) ? 0.0 : 1.0;
    });
}

double three_sigma(double p, int count)
{
    return 3 * std::sqrt(p * (1 - p) / std::max(1, count));
}

} // namespace atrium::truth
