#include "app/gui/light_view.hpp"

#include "app/gui/projection.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace atrium::gui {
namespace {

const Camera camera{{1, 2, 3}, {1, 2, -7}, 50};

Bounds scene()
{
    Bounds bounds;
    bounds.add(vec3(-4, 0, -6));
    bounds.add(vec3(4, 5, 6));
    return bounds;
}

Light light_of(LightType type)
{
    Light light = default_light(type);
    light.position = {5, 4, 0};
    light.direction = {0, -3, 4};
    return light;
}

void expect_near(const vec3& a, const vec3& b)
{
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-4f) << i;
}

TEST(light_view, a_spot_s_cone_fills_the_height)
{
    Light spot = light_of(LightType::spot);
    spot.outer = 35;
    const Camera view = view_of_light(spot, camera, scene());
    EXPECT_EQ(view.eye, spot.position);
    expect_near(view.target, {5, -2, 8}); // 10 m along it, as far as what was looked at
    EXPECT_EQ(view.fov, 70);
    const Projection projection(view, {800, 600});
    const vec3 direction = projection.forward,
               edge = std::cos(glm::radians(35.0f)) * direction + std::sin(glm::radians(35.0f)) * projection.up;
    EXPECT_NEAR(projection.project(view.eye + edge)->y, 0, 0.01);
    spot.outer = 0.1f;
    EXPECT_NO_THROW(check_camera(view_of_light(spot, camera, scene()), ExitCode::usage, ""));
}

TEST(light_view, a_point_keeps_the_direction)
{
    const Camera view = view_of_light(light_of(LightType::point), camera, scene());
    expect_near(view.eye, {5, 4, 0});
    expect_near(view.target, {5, 4, -10});
    EXPECT_EQ(view.fov, camera.fov);
}

TEST(light_view, a_rectangle_looks_along_its_normal)
{
    const Camera view = view_of_light(light_of(LightType::rect), camera, scene());
    expect_near(view.eye, {5, 4, 0});
    expect_near(view.target, {5, -2, 8});
    EXPECT_EQ(view.fov, camera.fov);
}

TEST(light_view, a_sun_sees_the_whole_scene_from_afar)
{
    const Camera view = view_of_light(light_of(LightType::sun), camera, scene());
    expect_near(glm::normalize(view.target - view.eye), {0, -0.6f, 0.8f});
    expect_near(view.target, scene().centre());
    const Projection projection(view, {600, 600});
    for (const float x : {-4.0f, 4.0f}) {
        for (const float y : {0.0f, 5.0f}) {
            for (const float z : {-6.0f, 6.0f}) {
                const auto pixel = projection.project({x, y, z});
                ASSERT_TRUE(pixel.has_value());
                EXPECT_EQ(*pixel, glm::clamp(*pixel, vec2(0), vec2(600)));
            }
        }
    }
    EXPECT_NO_THROW(check_camera(view_of_light(light_of(LightType::sun), camera, {}), ExitCode::usage, ""));
}

TEST(light_view, the_second_time_leads_back)
{
    Camera moving = camera;
    LightView view;
    EXPECT_FALSE(view.toggle(moving, nullptr, scene()));
    EXPECT_EQ(moving, camera);
    const Light spot = light_of(LightType::spot);
    EXPECT_TRUE(view.toggle(moving, &spot, scene()));
    EXPECT_EQ(moving.eye, spot.position);
    moving.eye.x += 1;                                  // flown meanwhile
    EXPECT_TRUE(view.toggle(moving, nullptr, scene())); // the light may be gone
    EXPECT_EQ(moving, camera);
}

} // namespace
} // namespace atrium::gui
