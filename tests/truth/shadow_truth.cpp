#include "tests/truth/shadow_truth.hpp"

#include "renderer/core/jobs.hpp"

#include <cmath>

namespace atrium::truth {
namespace {

constexpr double pi_d = 3.14159265358979323846;

Surfel surfel_at(const PrimaryBuffers& primary, int x, int y)
{
    const float *p = primary.position.at(x, y), *n = primary.geometric_normal.at(x, y);
    return {dvec3(p[0], p[1], p[2]), dvec3(n[0], n[1], n[2])};
}

/// Unit vector to the light's centre, and whether its light gets there.
struct Reach {
    dvec3 to_light;
    bool reached;
};

Reach reach_of(const Light& light, const Surfel& at)
{
    const LightAxes axes = axes_of(light);
    const dvec3 along(axes.direction);
    if (light.type == LightType::sun) return {-along, true};
    const dvec3 d = dvec3(light.position) - at.position;
    const double distance = glm::length(d);
    const dvec3 to = d / distance;
    bool reached = light.range <= 0 || light.type == LightType::rect || distance < static_cast<double>(light.range);
    if (light.type == LightType::spot)
        reached = reached && glm::dot(-to, along) > std::cos(static_cast<double>(light.outer) * pi_d / 180);
    if (light.type == LightType::rect) reached = glm::dot(-to, along) > 0;
    return {to, reached};
}

double visibility_at(const TruthScene& scene, const Surfel& at, const Light& light, int count, std::uint64_t seed)
{
    const Sampling sampling{count, seed};
    const LightAxes axes = axes_of(light);
    const dvec3 centre(light.position);
    if (count <= 1) {
        if (light.type != LightType::sun) return point_visibility(scene, at, centre);
        return sun_visibility(scene, at, dvec3(axes.direction), 0, sampling);
    }
    switch (light.type) {
    case LightType::sun:
        return sun_visibility(scene, at, dvec3(axes.direction), static_cast<double>(light.angle), sampling);
    case LightType::rect:
        return area_visibility(scene, at,
                               {centre, dvec3(axes.right) * (0.5 * static_cast<double>(light.width)),
                                dvec3(axes.up) * (0.5 * static_cast<double>(light.height)), false},
                               sampling);
    default:
        return area_visibility(scene, at, disc_towards(at.position, centre, static_cast<double>(light.size)), sampling);
    }
}

} // namespace

ImageF cast_visibility(const TruthScene& scene, const PrimaryBuffers& primary, const Light& light, int count)
{
    const int width = primary.depth.width, height = primary.depth.height;
    ImageF out(width, height, 1);
    parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) {
            *out.at(x, y) = 1;
            if (!primary.surface.at(x, y)) continue;
            const Surfel at = surfel_at(primary, x, y);
            if (!reach_of(light, at).reached) continue;
            const auto seed =
                static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(width) + static_cast<std::uint64_t>(x);
            *out.at(x, y) = static_cast<float>(visibility_at(scene, at, light, count, seed));
        }
    });
    return out;
}

Mask lit_pixels(const PrimaryBuffers& primary, const Light& light)
{
    Mask out = without(primary.surface, silhouettes(primary));
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            if (!out.at(x, y)) continue;
            const Surfel at = surfel_at(primary, x, y);
            const Reach reach = reach_of(light, at);
            out.set(x, y, reach.reached && glm::dot(at.normal, reach.to_light) >= 0.1);
        }
    }
    return out;
}

VisibilityError compare_visibility(const ImageF& truth, const ImageF& got, const Mask& mask)
{
    VisibilityError e;
    double compared = 0, penumbra = 0, squares = 0, penumbra_squares = 0, bias = 0, wrong = 0;
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            if (!mask.at(x, y)) continue;
            const double t = static_cast<double>(*truth.at(x, y)), d = static_cast<double>(*got.at(x, y)) - t;
            compared += 1;
            squares += d * d;
            if (std::abs(d) > 0.5) wrong += 1;
            if (t <= 0.02 || t >= 0.98) continue;
            penumbra += 1;
            penumbra_squares += d * d;
            bias += d;
        }
    }
    if (compared == 0) return e;
    e.wrong = wrong / compared;
    e.rmse = std::sqrt(squares / compared);
    e.penumbra_share = penumbra / compared;
    e.share = compared / (static_cast<double>(mask.width) * mask.height);
    if (penumbra == 0) return e;
    e.penumbra_rmse = std::sqrt(penumbra_squares / penumbra);
    e.penumbra_bias = bias / penumbra;
    return e;
}

} // namespace atrium::truth
