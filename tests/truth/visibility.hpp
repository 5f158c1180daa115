#pragma once
// Shadows and ambient occlusion by brute force: the simple, honest versions. Samples are stratified and depend on
// nothing but the seed. Secondary rays never cull by facing and see masks; they start
// p + n * 1e-4 * max(1, |p|_inf), n the geometric normal.

#include "tests/truth/truth_scene.hpp"

#include <cstdint>

namespace atrium::truth {

/// A point of a surface and the unit normal of its plane, on the side that is asked about.
struct Surfel {
    dvec3 position{0};
    dvec3 normal{0, 1, 0};
};

/// A flat light: all of centre + a * half_u + b * half_v, (a, b) in the square -1..1 or in the unit disc.
struct AreaLight {
    dvec3 centre{0};
    dvec3 half_u{0.5, 0, 0}, half_v{0, 0, 0.5};
    bool disc = false;
};

/// The disc that a sphere shows to `from`: spot and point lights with a radius.
[[nodiscard]] AreaLight disc_towards(const dvec3& from, const dvec3& centre, double radius);

/// How many samples and which. The count is rounded down to a square, at least 1.
struct Sampling {
    int count = 1024;
    std::uint64_t seed = 1;
};

/// 1 where the light's point is seen, else 0.
[[nodiscard]] double point_visibility(const TruthScene& scene, const Surfel& at, const dvec3& light);
/// Share of the light's area that is seen, whatever its angle.
[[nodiscard]] double area_visibility(const TruthScene& scene, const Surfel& at, const AreaLight& light,
                                     const Sampling& sampling);
/// Share of the sun's disc that is seen. `travel`: the way its light goes; `angle`: its diameter, degrees.
[[nodiscard]] double sun_visibility(const TruthScene& scene, const Surfel& at, const dvec3& travel, double angle,
                                    const Sampling& sampling);
/// Illuminance from an area light of radiance 1 that shines to the side of cross(half_u, half_v), shadowed.
[[nodiscard]] double area_illuminance(const TruthScene& scene, const Surfel& at, const AreaLight& light,
                                      const Sampling& sampling);
/// Cosine-weighted share of directions in which nothing stands within `radius` (m, may be infinite), 0..1.
/// Directions are uniform on the unit disc (Nusselt).
[[nodiscard]] double ambient_visibility(const TruthScene& scene, const Surfel& at, double radius,
                                        const Sampling& sampling);

/// What sampling alone may put between two answers: 3 standard deviations of the mean of `count` independent samples of
/// which a share p is 1. Stratified samples stay below.
[[nodiscard]] double three_sigma(double p, int count);

} // namespace atrium::truth
