#include "app/gui/fly_camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace atrium::gui {
namespace {

constexpr float degree = pi / 180.0f;

void expect_near(const vec3& a, const vec3& b, float tolerance = 1e-5f)
{
    EXPECT_LT(glm::length(a - b), tolerance)
        << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

FlyInput moving(const vec3& move)
{
    FlyInput input;
    input.move = move;
    return input;
}

FlyInput turning(float right, float up)
{
    FlyInput input;
    input.turn = {right, up};
    return input;
}

vec3 view_of(const Camera& camera)
{
    return glm::normalize(camera.target - camera.eye);
}

TEST(fly_camera, a_second_forward_at_two_metres_per_second_is_two_metres_along_the_view)
{
    FlyCamera fly;
    fly.speed = 2;
    Camera camera{{1, 2, 3}, {4, 6, 3}, 60}; // 5 m away, along (0.6, 0.8, 0)
    EXPECT_TRUE(fly.advance(camera, moving({0, 0, 1}), 1.0));
    expect_near(camera.eye, {2.2f, 3.6f, 3});
    expect_near(camera.target, {5.2f, 7.6f, 3});
    EXPECT_EQ(camera.fov, 60.0f);
}

TEST(fly_camera, right_is_level_and_up_is_up)
{
    FlyCamera fly;
    fly.speed = 1;
    Camera camera{{0, 0, 0}, {0, -3, -4}, 60};
    fly.advance(camera, moving({1, 0, 0}), 1.0);
    expect_near(camera.eye, {1, 0, 0});
    fly.advance(camera, moving({0, 1, 0}), 2.0);
    expect_near(camera.eye, {1, 2, 0});
    fly.advance(camera, moving({-1, 0, 0}), 1.0);
    expect_near(camera.eye, {0, 2, 0});
}

TEST(fly_camera, two_keys_are_no_faster_than_one_and_shift_is_four_times_as_fast)
{
    FlyCamera fly;
    fly.speed = 3;
    Camera camera{{0, 0, 0}, {0, 0, -1}, 60};
    FlyInput input = moving({1, 0, 1});
    fly.advance(camera, input, 1.0);
    EXPECT_NEAR(glm::length(camera.eye), 3.0f, 1e-5f);
    camera = {{0, 0, 0}, {0, 0, -1}, 60};
    input.fast = true;
    fly.advance(camera, input, 1.0);
    EXPECT_NEAR(glm::length(camera.eye), 12.0f, 1e-5f);
}

TEST(fly_camera, parts_of_a_step_add_up_to_it)
{
    // Moving, turning and running into the steepest pitch, all at once.
    const Camera start{{3, 1.5f, -2}, {7, 2, 1}, 60};
    FlyInput whole = moving({0.5f, -0.25f, 1});
    whole.turn = {2.5f, 1.9f};
    for (const int parts : {2, 7, 1000}) {
        FlyCamera one, many;
        Camera a = start, b = start;
        one.advance(a, whole, 1.5);
        FlyInput part = whole;
        part.turn /= static_cast<float>(parts);
        for (int i = 0; i < parts; ++i) many.advance(b, part, 1.5 / parts);
        expect_near(a.eye, b.eye);
        expect_near(a.target, b.target);
    }
}

TEST(fly_camera, a_quarter_circle_has_the_length_that_was_flown)
{
    FlyCamera fly;
    fly.speed = pi; // in 1 s a quarter circle of radius 2
    Camera camera{{0, 0, 0}, {0, 0, -1}, 60};
    FlyInput input = moving({0, 0, 1});
    input.turn = {90 * degree, 0};
    fly.advance(camera, input, 1.0);
    expect_near(camera.eye, {2, 0, -2});
    expect_near(view_of(camera), {1, 0, 0});
}

TEST(fly_camera, turns_right_and_up)
{
    FlyCamera fly;
    Camera camera{{1, 1, 1}, {1, 1, -4}, 60};
    EXPECT_TRUE(fly.advance(camera, turning(90 * degree, 0), 0.0));
    expect_near(camera.target, {6, 1, 1});
    fly.advance(camera, turning(0, 30 * degree), 0.0);
    expect_near(view_of(camera), {std::cos(30 * degree), 0.5f, 0});
    EXPECT_EQ(camera.eye, vec3(1));
}

TEST(fly_camera, pitch_stops_at_89_degrees)
{
    FlyCamera fly;
    Camera camera{{0, 0, 0}, {3, 0, 0}, 60};
    for (int i = 0; i < 40; ++i) fly.advance(camera, turning(0, 0.1f), 0.0);
    EXPECT_NEAR(std::asin(view_of(camera).y) / degree, 89.0f, 0.01f);
    EXPECT_GT(camera.target.x, 0.0f); // never beyond the pole
    EXPECT_FALSE(fly.advance(camera, turning(0, 0.1f), 0.0));
    fly.advance(camera, turning(0, -10), 0.0);
    EXPECT_NEAR(std::asin(view_of(camera).y) / degree, -89.0f, 0.01f);
    EXPECT_NEAR(glm::length(camera.target), 3.0f, 1e-5f);
}

TEST(fly_camera, a_full_turn_comes_back)
{
    FlyCamera fly;
    const Camera start{{10, 2, -7}, {2, 5, 3}, 60};
    Camera camera = start;
    for (int i = 0; i < 360; ++i) fly.advance(camera, turning(degree, 0), 1.0 / 60);
    expect_near(camera.target, start.target, 2e-5f);
    EXPECT_EQ(camera.eye, start.eye);
    EXPECT_NEAR(glm::length(camera.target - camera.eye), glm::length(start.target - start.eye), 1e-5f);
}

TEST(fly_camera, thousands_of_small_steps_lose_nothing)
{
    FlyCamera fly;
    fly.speed = 2;
    Camera camera{{1000, 0, 0}, {1000, 0, -1}, 60};
    for (int i = 0; i < 100000; ++i) fly.advance(camera, moving({1, 0, 0}), 1e-4); // 0.2 mm each: 3 units of a float
    EXPECT_FLOAT_EQ(camera.eye.x, 1020.0f);
}

TEST(fly_camera, looking_straight_down_and_up_turns_as_the_screen_shows_it)
{
    // Right stays right on the screen: first rows of the view matrix.
    for (const vec3& view : {vec3(0, -1, 0), vec3(0, 1, 0)}) {
        FlyCamera fly;
        fly.speed = 1;
        Camera camera{{0, 0, 0}, view, 60};
        const mat4 m = view_from_world(camera);
        const vec3 right(m[0][0], m[1][0], m[2][0]);
        fly.advance(camera, moving({1, 0, 0}), 1.0);
        expect_near(camera.eye, right);
        fly.advance(camera, turning(0, 0.001f), 0.0);
        const mat4 after = view_from_world(camera);
        expect_near(vec3(after[0][0], after[1][0], after[2][0]), right, 1e-3f);
    }
}

TEST(fly_camera, follows_a_camera_that_was_put_elsewhere)
{
    FlyCamera fly;
    fly.speed = 1;
    Camera camera{{0, 0, 0}, {0, 0, -1}, 60};
    fly.advance(camera, moving({0, 0, 1}), 1.0);
    camera = {{5, 5, 5}, {6, 5, 5}, 40};
    fly.advance(camera, moving({0, 0, 1}), 1.0);
    expect_near(camera.eye, {6, 5, 5});
    EXPECT_EQ(camera.fov, 40.0f);
}

TEST(fly_camera, speed_comes_from_the_scene_and_the_wheel)
{
    FlyCamera fly(40);
    EXPECT_DOUBLE_EQ(fly.speed, 2.0);
    Camera camera;
    FlyInput input;
    input.wheel = 8;
    EXPECT_FALSE(fly.advance(camera, input, 1.0));
    EXPECT_DOUBLE_EQ(fly.speed, 4.0);
    input.wheel = -16;
    fly.advance(camera, input, 1.0);
    EXPECT_DOUBLE_EQ(fly.speed, 1.0);
    EXPECT_GT(FlyCamera(0).speed, 0.0);
}

TEST(fly_camera, stays_a_camera_at_the_end_of_the_world)
{
    FlyCamera fly;
    fly.speed = 1e5;
    Camera camera{{0, 0, 0}, {10, 0, 0}, 60};
    for (int i = 0; i < 100; ++i) fly.advance(camera, moving({0, 0, 1}), 1.0);
    EXPECT_GT(camera.eye.x, 0.9e6f);
    EXPECT_NO_THROW(check_camera(camera, ExitCode::usage, ""));
}

} // namespace
} // namespace atrium::gui
