#include "app/gui/framing.hpp"

#include "app/gui/projection.hpp"

#include <gtest/gtest.h>

namespace atrium::gui {
namespace {

constexpr float diagonal = 20;

TEST(framing, a_light_comes_into_the_middle_at_a_sensible_distance)
{
    const vec2 display(800, 600);
    for (const LightType type : {LightType::spot, LightType::point, LightType::rect}) {
        for (const vec3& at : {vec3(3, 2, 1), vec3(-100, 0, 5), vec3(0, 1.7f, 4.999f), Camera{}.eye}) {
            Light light = default_light(type);
            light.position = at;
            const Camera camera = frame_light(Camera{}, light, diagonal);
            const auto pixel = Projection(camera, display).project(at);
            ASSERT_TRUE(pixel.has_value());
            EXPECT_NEAR(pixel->x, 400, 0.1);
            EXPECT_NEAR(pixel->y, 300, 0.1);
            EXPECT_GE(glm::distance(camera.eye, at), 0.3999f);
            EXPECT_LE(glm::distance(camera.eye, at), 3.0001f);
            EXPECT_NO_THROW(check_camera(camera, ExitCode::usage, ""));
        }
    }
}

TEST(framing, a_light_at_a_sensible_distance_is_only_turned_to)
{
    Light light = default_light(LightType::point);
    light.position = Camera{}.eye + vec3(2, 0, 0);
    EXPECT_NEAR(glm::distance(frame_light(Camera{}, light, diagonal).eye, Camera{}.eye), 0, 1e-6);
}

TEST(framing, of_a_sun_the_place_it_shines_from)
{
    Light sun = default_light(LightType::sun);
    sun.direction = {0, 0, -2};
    const Camera camera = frame_light(Camera{}, sun, diagonal);
    EXPECT_EQ(camera.eye, Camera{}.eye);
    EXPECT_NEAR(camera.target.z, 10, 1e-5); // as far as what it looked at
}

} // namespace
} // namespace atrium::gui
