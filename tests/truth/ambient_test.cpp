// Ambient visibility against closed forms (Nusselt: areas of the unit disc over pi).

#include "tests/truth/closed_forms.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/visibility.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace atrium::truth {
namespace {

constexpr int samples = 4096;

double visibility(const TruthScene& scene, const dvec3& at, double radius, std::uint64_t seed = 1)
{
    return ambient_visibility(scene, {at, {0, 1, 0}}, radius, {samples, seed});
}

TEST(ambient, an_open_plane_sees_everything)
{
    const TempBake bake(floor_scene());
    const TruthScene scene(bake.file());
    EXPECT_EQ(visibility(scene, {0.3, 0, -0.2}, std::numeric_limits<double>::infinity()), 1);
    EXPECT_EQ(ambient_visibility(scene, {{0.3, 0, -0.2}, {0, -1, 0}}, 5, {64}), 1); // its back too
}

TEST(ambient, floor_beside_a_wall_matches_the_closed_form)
{
    const TempBake bake(wall_and_floor());
    const TruthScene scene(bake.file());
    const double table[][2]{{0.001, .5}, {.1, .56356}, {.25, .65748}, {.5, .80450}, {.75, .92785}, {.9, .98131}};
    for (const auto& [k, expected] : table) {
        if (k > 0.01) {
            EXPECT_NEAR(1 - beyond_chord(k), expected, 1e-5);
        }
        EXPECT_NEAR(visibility(scene, {k, 0, 0.37}, 1), expected, three_sigma(expected, samples)) << k;
        EXPECT_NEAR(visibility(scene, {2 * k, 0, 0.37}, 2), expected, three_sigma(expected, samples)) << k;
    }
    EXPECT_EQ(visibility(scene, {1.01, 0, 0}, 1), 1);
}

TEST(ambient, a_corner_of_three_planes_matches_the_closed_form)
{
    const TempBake bake(corner_scene());
    const TruthScene scene(bake.file());
    const double table[][2]{{0.001, .25}, {.1, .31674}, {.25, .42738}, {.5, .63408}};
    for (const auto& [k, expected] : table) {
        if (k > 0.01) {
            EXPECT_NEAR(1 - 2 * beyond_chord(k) + beyond_both(k, k), expected, 1e-5);
        }
        EXPECT_NEAR(visibility(scene, {k, 0, k}, 1), expected, three_sigma(expected, samples)) << k;
    }
    const double uneven = 1 - beyond_chord(0.2) - beyond_chord(0.6) + beyond_both(0.2, 0.6);
    EXPECT_NEAR(visibility(scene, {0.2, 0, 0.6}, 1), uneven, three_sigma(uneven, samples));
}

TEST(ambient, under_a_ceiling_it_is_the_square_of_height_over_radius)
{
    const TempBake bake(ceiling_scene(0.6f));
    const TruthScene scene(bake.file());
    for (const double radius : {0.7, 1.0, 2.0}) {
        const double expected = 0.36 / (radius * radius);
        EXPECT_NEAR(visibility(scene, {0.4, 0, 0.1}, radius), expected, three_sigma(expected, samples)) << radius;
    }
    EXPECT_EQ(visibility(scene, {0.4, 0, 0.1}, 0.59), 1);
}

TEST(ambient, beside_a_resting_sphere_it_matches_the_form_factor)
{
    const TempBake bake(sphere_on_floor(1));
    const TruthScene scene(bake.file());
    const double table[][2]{{.5, .28446}, {1, .64645}, {2, .91056}};
    for (const auto& [d, expected] : table) {
        EXPECT_NEAR(1 - std::pow(1 + d * d, -1.5), expected, 1e-5);
        // The sphere is made of flat faces: 0.0006 of its radius are missing.
        EXPECT_NEAR(visibility(scene, {d * 0.8, 0, d * 0.6}, std::numeric_limits<double>::infinity()), expected,
                    three_sigma(expected, samples) + 0.002)
            << d;
    }
}

TEST(ambient, more_samples_mean_less_variance)
{
    const TempBake bake(wall_and_floor());
    const TruthScene scene(bake.file());
    const auto variance = [&](int count) {
        const double expected = 1 - beyond_chord(0.5);
        double sum = 0;
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            const double e = ambient_visibility(scene, {{0.5, 0, 0}, {0, 1, 0}}, 1, {count, seed}) - expected;
            sum += e * e;
        }
        return sum / 200;
    };
    const double few = variance(64), many = variance(256);
    EXPECT_LT(many, few / 3);       // at least by the ratio of the counts, 4, less what 200 trials leave open
    EXPECT_LT(few, 0.8 * 0.2 / 64); // and below independent samples
    EXPECT_EQ(visibility(scene, {0.5, 0, 0}, 1, 7), visibility(scene, {0.5, 0, 0}, 1, 7));
    EXPECT_NE(variance(16), 0);
}

} // namespace
} // namespace atrium::truth
