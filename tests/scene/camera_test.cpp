#include "renderer/scene/camera.hpp"
#include "renderer/scene/default_camera.hpp"
#include "tests/core/expect_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace atrium {
namespace {

using test::expect_error;

vec3 ndc(const mat4& clip, const mat4& view, const vec3& p)
{
    const vec4 c = clip * view * vec4(p, 1);
    return vec3(c) / c.w;
}

void expect_near(const vec3& a, const vec3& b, float tolerance)
{
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(camera, depth_is_near_over_distance)
{
    const mat4 view = view_from_world({{0, 0, 0}, {0, 0, -1}, 60});
    const mat4 clip = clip_from_view(60, 1.5f, 0.1f);
    for (const float distance : {0.1f, 0.5f, 1.0f, 20.0f, 1e5f}) {
        EXPECT_FLOAT_EQ(ndc(clip, view, {0, 0, -distance}).z, 0.1f / distance);
    }
}

TEST(camera, the_frustum_edge_is_half_the_vertical_angle)
{
    const mat4 clip = clip_from_view(90, 2.0f, 0.1f);
    expect_near(ndc(clip, mat4(1), {0, 3, -3}), {0, 1, 0.1f / 3}, 1e-6f); // up is +1, 45 degrees is the edge
    expect_near(ndc(clip, mat4(1), {6, 0, -3}), {1, 0, 0.1f / 3}, 1e-6f); // twice as wide as high
}

TEST(camera, view_is_right_handed_with_y_up)
{
    const mat4 view = view_from_world({{1, 2, 3}, {1, 2, -7}, 60}); // looks along -Z
    EXPECT_EQ(vec3(view * vec4(1, 2, 3, 1)), vec3(0));
    EXPECT_EQ(vec3(view * vec4(2, 2, 3, 1)), vec3(1, 0, 0));
    EXPECT_EQ(vec3(view * vec4(1, 3, 3, 1)), vec3(0, 1, 0));
    EXPECT_EQ(vec3(view * vec4(1, 2, -7, 1)), vec3(0, 0, -10));

    const mat4 sideways = view_from_world({{0, 1, 0}, {5, 1, 0}, 60}); // looks along +X: +Z is right
    EXPECT_EQ(vec3(sideways * vec4(5, 1, 0, 1)), vec3(0, 0, -5));
    EXPECT_EQ(vec3(sideways * vec4(0, 1, 2, 1)), vec3(2, 0, 0));
}

TEST(camera, straight_down_and_up_are_exact)
{
    const mat4 down = view_from_world({{3, 10, -2}, {3, 0, -2}, 60});
    EXPECT_EQ(vec3(down * vec4(3, 0, -2, 1)), vec3(0, 0, -10));
    EXPECT_EQ(vec3(down * vec4(3, 0, -1, 1)), vec3(0, 1, -10));  // +Z is up
    EXPECT_EQ(vec3(down * vec4(4, 0, -2, 1)), vec3(-1, 0, -10)); // and +X is left
    const mat4 up = view_from_world({{3, 0, -2}, {3, 10, -2}, 60});
    EXPECT_EQ(vec3(up * vec4(3, 10, -1, 1)), vec3(0, 1, -10));
    EXPECT_EQ(vec3(up * vec4(4, 10, -2, 1)), vec3(1, 0, -10));
}

TEST(camera, nearly_vertical_keeps_y_up_and_unit_axes)
{
    const mat4 view = view_from_world({{0, 10, 0}, {0.01f, 0, 0}, 60});
    const mat3 turn(view);
    expect_near(vec3(glm::transpose(turn) * turn * vec3(1, 2, 3)), {1, 2, 3}, 1e-5f);
    EXPECT_GT((turn * vec3(0, 1, 0)).y, 0.0f);
}

TEST(camera, eye_equal_to_target_gives_no_nan)
{
    const mat4 view = view_from_world({{1, 1, 1}, {1, 1, 1}, 60});
    EXPECT_EQ(vec3(view * vec4(1, 1, 0, 1)), vec3(0, 0, -1));
}

Bounds box(const vec3& min, const vec3& max)
{
    Bounds b;
    b.add(min);
    b.add(max);
    return b;
}

/// The area of the picture that points cover, each axis from -1 to 1.
struct Frame {
    vec2 low{1e9f}, high{-1e9f};
    float nearest = 1e9f; ///< m along the view axis
};

Frame projected(const Camera& camera, float aspect, std::span<const vec3> points)
{
    const mat4 view = view_from_world(camera), clip = clip_from_view(camera.fov, aspect, 1e-3f);
    Frame frame;
    for (const vec3& p : points) {
        const vec2 at(ndc(clip, view, p));
        frame.low = glm::min(frame.low, at);
        frame.high = glm::max(frame.high, at);
        frame.nearest = std::min(frame.nearest, -(view * vec4(p, 1)).z);
    }
    return frame;
}

/// In the middle both ways, and, unless that would be too close to the nearest point, as large as the picture's tighter
/// side says.
void expect_framed(const Frame& frame, const std::string& what, bool close_enough = true)
{
    EXPECT_NEAR(frame.low.x, -frame.high.x, 2e-3f) << what;
    EXPECT_NEAR(frame.low.y, -frame.high.y, 2e-3f) << what;
    EXPECT_LT(std::max(frame.high.x, frame.high.y), framed_share + 2e-3f) << what;
    if (close_enough) {
        EXPECT_GT(std::max(frame.high.x, frame.high.y), framed_share - 2e-3f) << what;
    }
    EXPECT_GT(frame.nearest, 0) << what;
}

std::vector<vec3> corners_of(const Bounds& b)
{
    std::vector<vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? b.max.x : b.min.x, (i & 2) != 0 ? b.max.y : b.min.y,
                             (i & 4) != 0 ? b.max.z : b.min.z);
    }
    return corners;
}

TEST(camera, framing_fills_the_picture_from_30_degrees_above)
{
    static_assert(framed_share >= 0.8f && framed_share <= 0.9f);
    const Bounds boxes[] = {box({-1, 0, -1}, {1, 2, 1}),
                            box({10, -5, 0}, {60, -4, 1}),
                            box({0, 0, 0}, {1, 80, 2}),
                            box({-3, 1, -2}, {4, 1, 5}), // flat
                            box({2, 0, 0}, {2, 3, 4}),
                            box({0, 0, 0}, {0, 0, 7}), // a line
                            box({0, 0, 0}, {1e-4f, 1e-4f, 1e-4f}),
                            box({-2e4f, 0, -3e4f}, {2e4f, 100, 3e4f})};
    for (const Bounds& b : boxes) {
        for (const float aspect : {16.0f / 9.0f, 1.0f, 0.5f, 4.0f}) {
            for (const float fov : {20.0f, 60.0f, 120.0f}) {
                const Camera camera = frame_bounds(b, fov, aspect);
                const vec3 d = glm::normalize(camera.target - camera.eye);
                EXPECT_NEAR(std::asin(-d.y) * 180 / pi, 30, 2e-2f);
                const Frame frame = projected(camera, aspect, corners_of(b));
                const std::string what = std::to_string(&b - boxes) + " at " + std::to_string(aspect);
                expect_framed(frame, what, fov <= 60);
                EXPECT_GT(frame.nearest, default_near(b)) << what;
            }
        }
    }
}

TEST(camera, framing_looks_at_points_and_not_at_their_box)
{
    // A ball, of which the box is much larger to the eye; of two sets, one moved and scaled.
    std::vector<vec3> ball;
    for (int i = 0; i < 4000; ++i) {
        const float y = 1 - 2 * (static_cast<float>(i) + 0.5f) / 4000, r = std::sqrt(1 - y * y);
        const float angle = 2.39996323f * static_cast<float>(i);
        ball.emplace_back(r * std::cos(angle), y, r * std::sin(angle));
    }
    mat4 moved(3);
    moved[3] = vec4(7, 1, -2, 1);
    const std::byte* first = std::as_bytes(std::span(ball)).data();
    const PointSet sets[] = {{first, sizeof(vec3), ball.size()}, {first, sizeof(vec3), ball.size(), moved}};
    for (const float aspect : {16.0f / 9.0f, 0.6f}) {
        expect_framed(projected(frame_points({sets, 1}, 60, aspect), aspect, ball), "one ball");
        std::vector<vec3> both = ball;
        for (const vec3& p : ball) both.emplace_back(moved * vec4(p, 1));
        expect_framed(projected(frame_points(sets, 60, aspect), aspect, both), "two balls");
    }
    ball[7].x = std::numeric_limits<float>::quiet_NaN(); // of a damaged file
    EXPECT_NO_THROW(check_camera(frame_points({sets, 1}, 60, 1), ExitCode::internal, ""));
}

TEST(camera, inside_looks_along_the_longer_axis)
{
    const Camera x = inside_bounds(box({-20, 0, -5}, {20, 15, 5}), 70);
    EXPECT_EQ(x.eye, vec3(0, 5, 0));
    EXPECT_GT(x.target.x, x.eye.x);
    EXPECT_EQ(x.target.y, x.eye.y);
    EXPECT_EQ(x.target.z, x.eye.z);
    EXPECT_EQ(x.fov, 70.0f);
    const Camera z = inside_bounds(box({0, 1, -5}, {4, 4, 5}), 60); // a room 3 m high: the eye 1.7 m above its floor
    EXPECT_EQ(z.eye, vec3(2, 2.7f, 0));
    EXPECT_LT(z.target.z, z.eye.z);
    const Camera low = inside_bounds(box({0, 0, 0}, {1, 1, 1}), 60); // too low for a person
    EXPECT_FLOAT_EQ(low.eye.y, 0.6f);
}

TEST(camera, empty_and_pointlike_bounds_give_usable_cameras)
{
    for (const Bounds& b : {Bounds{}, box({1, 2, 3}, {1, 2, 3})}) {
        for (const Camera& c : {frame_bounds(b, 60, 1), inside_bounds(b, 60)}) {
            EXPECT_NO_THROW(check_camera(c, ExitCode::internal, ""));
        }
    }
}

TEST(camera, near_plane_follows_the_scene)
{
    EXPECT_FLOAT_EQ(default_near(box({0, 0, 0}, {30, 40, 0})), 0.0025f); // 50 / 20000
    EXPECT_EQ(default_near(box({0, 0, 0}, {0.1f, 0, 0})), 0.001f);
    EXPECT_EQ(default_near(box({0, 0, 0}, {1e5f, 0, 0})), 0.1f);
    EXPECT_EQ(default_near({}), 0.001f);
    EXPECT_FLOAT_EQ(default_near(box({0, 0, 0}, {1e-3f, 0, 0})), 5e-5f); // else nothing would be left to see
}

TEST(camera, check_refuses_what_cannot_be_drawn)
{
    const auto check = [](const Camera& c) { check_camera(c, ExitCode::usage, "--eye"); };
    EXPECT_NO_THROW(check({{0, 0, 0}, {0, 0, 1}, 60}));
    expect_error([&] { check({{1, 1, 1}, {1, 1, 1}, 60}); }, ExitCode::usage, "same point", "--eye");
    for (const float fov : {1.0f, 170.0f, -5.0f, std::numeric_limits<float>::quiet_NaN()}) {
        expect_error([&] { check({{0, 0, 0}, {0, 0, 1}, fov}); }, ExitCode::usage, "between 1 and 170");
    }
    for (const float x : {2e6f, -2e6f, std::numeric_limits<float>::quiet_NaN()}) {
        expect_error([&] { check({{x, 0, 0}, {0, 0, 1}, 60}); }, ExitCode::usage, "outside the world");
        expect_error([&] { check({{0, 0, 0}, {0, 0, x}, 60}); }, ExitCode::usage, "outside the world");
    }
}

} // namespace
} // namespace atrium
