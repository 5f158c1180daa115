// Shadows and illuminance against closed forms.

#include "tests/truth/scene_builder.hpp"
#include "tests/truth/visibility.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace atrium::truth {
namespace {

constexpr double pi_d = 3.14159265358979323846;
constexpr int samples = 1024;

/// A plate 2 m above the floor covers x > 0, a light hangs 4 m up: penumbrae are as wide as the light.
class Penumbra : public testing::Test {
protected:
    static constexpr double width = 0.5; ///< of the light, and so of the penumbra
    static Surfel floor_at(double x) { return {{x, 0, 0.1}, {0, 1, 0}}; }
    static AreaLight light(bool disc) { return {{0, 4, 0.1}, {width / 2, 0, 0}, {0, 0, width / 2}, disc}; }

    TempBake bake_{plate_over_floor(2)};
    TruthScene scene_{bake_.file()};
};

TEST_F(Penumbra, of_a_point_is_a_step)
{
    EXPECT_EQ(point_visibility(scene_, floor_at(-0.001), {0, 4, 0.1}), 1);
    EXPECT_EQ(point_visibility(scene_, floor_at(0.001), {0, 4, 0.1}), 0);
}

TEST_F(Penumbra, of_a_square_is_a_ramp)
{
    for (const double x : {-0.3, -0.2, -0.125, -0.05, 0.0, 0.1, 0.2, 0.3}) {
        const double expected = std::clamp(0.5 - x / width, 0.0, 1.0);
        EXPECT_NEAR(area_visibility(scene_, floor_at(x), light(false), {samples}), expected,
                    three_sigma(expected, samples) + 1e-4 / width)
            << x;
    }
}

TEST_F(Penumbra, of_a_disc_is_the_area_of_its_segment)
{
    // u: -1 at the end of the lit side, 1 at the end of the dark one.
    const double table[][2]{{-.75, .92785}, {-.5, .8045}, {-.25, .65748}, {0, .5},
                            {.25, .34252},  {.5, .1955},  {.75, .07215}};
    for (const auto& [u, expected] : table) {
        EXPECT_NEAR(0.5 - (u * std::sqrt(1 - u * u) + std::asin(u)) / pi_d, expected, 1e-5);
        EXPECT_NEAR(area_visibility(scene_, floor_at(u * width / 2), light(true), {samples}), expected,
                    three_sigma(expected, samples) + 1e-4 / width)
            << u;
    }
    EXPECT_EQ(area_visibility(scene_, floor_at(-0.26), light(true), {samples}), 1);
    EXPECT_EQ(area_visibility(scene_, floor_at(0.26), light(true), {samples}), 0);
}

TEST_F(Penumbra, of_the_sun_widens_with_the_height_of_the_edge)
{
    const double angle = 4, half = 2 * std::tan(angle / 2 * pi_d / 180); // the edge is 2 m up
    for (const double u : {-0.5, 0.25}) {
        const double expected = 0.5 - (u * std::sqrt(1 - u * u) + std::asin(u)) / pi_d;
        EXPECT_NEAR(sun_visibility(scene_, floor_at(u * half), {0, -1, 0}, angle, {samples}), expected,
                    three_sigma(expected, samples) + 0.002)
            << u;
    }
    EXPECT_EQ(sun_visibility(scene_, floor_at(-1.05 * half), {0, -3, 0}, angle, {samples}), 1);
    EXPECT_EQ(sun_visibility(scene_, floor_at(1.05 * half), {0, -3, 0}, angle, {samples}), 0);
}

TEST_F(Penumbra, is_cast_by_backs_too)
{
    // From under the plate only its back is met; from above the floor's back hides a light below.
    EXPECT_EQ(point_visibility(scene_, floor_at(5), {5, 4, 0}), 0);
    EXPECT_EQ(point_visibility(scene_, {{-5, 1, 0}, {0, 1, 0}}, {-5, -1, 0}), 0);
}

TEST(lights, masks_let_light_through_their_holes)
{
    const std::array<std::uint8_t, 4> alpha{255, 0, 0, 255};
    const TempBake bake(masked_scene(2, 2, alpha));
    const TruthScene scene(bake.file());
    const auto seen = [&](double x, double y) { return point_visibility(scene, {{x, y, -1}, {0, 0, 1}}, {x, y, 3}); };
    EXPECT_EQ(seen(-0.5, 0.5), 0); // upper left texel
    EXPECT_EQ(seen(0.5, 0.5), 1);
    EXPECT_EQ(seen(-0.5, -0.5), 1);
    EXPECT_EQ(seen(0.5, -0.5), 0);
    EXPECT_EQ(seen(2, 0), 1);
}

TEST(lights, a_rect_above_the_point_has_the_textbook_form_factor)
{
    const TempBake bake(floor_scene());
    const TruthScene scene(bake.file());
    const Surfel at{{0, 0, 0}, {0, 1, 0}};
    // Facing down: cross(x, z) = -y. Corner above the point, 1 m x 1 m at 1 m; then centred, 2 m x 2 m.
    const AreaLight corner{{0.5, 1, 0.5}, {0.5, 0, 0}, {0, 0, 0.5}}, centred{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
    EXPECT_NEAR(area_illuminance(scene, at, corner, {samples}), pi_d * .138532, 0.001);
    EXPECT_NEAR(area_illuminance(scene, at, centred, {samples}), pi_d * .554126, 0.004);
    // A disc of radius 1 at 1 m: 1 / (1 + 1).
    const AreaLight disc{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, true};
    EXPECT_NEAR(area_illuminance(scene, at, disc, {samples}), pi_d / 2, 0.004);
    // Its back is dark.
    const AreaLight up{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    EXPECT_EQ(area_illuminance(scene, at, up, {samples}), 0);
}

TEST(lights, the_disc_of_a_sphere_faces_the_point)
{
    const AreaLight light = disc_towards({1, 2, 3}, {4, 6, 3}, 0.5);
    EXPECT_TRUE(light.disc);
    EXPECT_NEAR(glm::length(light.half_u), 0.5, 1e-12);
    EXPECT_NEAR(glm::length(light.half_v), 0.5, 1e-12);
    EXPECT_NEAR(glm::dot(light.half_u, dvec3(3, 4, 0)), 0, 1e-12);
    EXPECT_NEAR(glm::dot(light.half_v, dvec3(3, 4, 0)), 0, 1e-12);
    EXPECT_NEAR(glm::dot(light.half_u, light.half_v), 0, 1e-12);
    EXPECT_GT(glm::dot(glm::cross(light.half_u, light.half_v), dvec3(1, 2, 3) - light.centre), 0);
}

} // namespace
} // namespace atrium::truth
