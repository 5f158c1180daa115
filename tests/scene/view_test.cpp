// A frame's view: its matrices against points with known pixels, its jitter, its matrices of the previous frame.

#include "renderer/scene/view.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace atrium {
namespace {

ViewDescription description()
{
    ViewDescription d;
    d.camera = {{1, 2, 3}, {1, 2, 0}, 90}; // looks along -Z
    d.previous_camera = d.camera;
    d.render_size = {400, 200};
    d.near = 0.5f;
    return d;
}

/// Pixels from the upper left.
vec2 pixel(const mat4& clip_from_world, const vec3& point, uvec2 size)
{
    const vec4 clip = clip_from_world * vec4(point, 1);
    return (vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * vec2(size);
}

TEST(view, follows_from_camera_and_size)
{
    const View v = make_view(description());
    EXPECT_EQ(v.aspect, 2);
    EXPECT_NEAR(v.tangents.x, 2, 1e-6);
    EXPECT_NEAR(v.tangents.y, 1, 1e-6);
    EXPECT_EQ(v.axes.right, vec3(1, 0, 0));
    EXPECT_EQ(v.axes.up, vec3(0, 1, 0));
    EXPECT_EQ(v.axes.forward, vec3(0, 0, -1));
    const vec4 ahead = v.now.clip_from_world * vec4(1, 2, -1, 1); // 4 m in front
    EXPECT_NEAR(ahead.z / ahead.w, 0.125f, 1e-6) << "near / distance";
    const vec2 at = pixel(v.now.clip_from_world, {5, 4, -1}, v.render_size); // 4 m right, 2 m up
    EXPECT_NEAR(at.x, 300, 1e-3);
    EXPECT_NEAR(at.y, 50, 1e-3);
    EXPECT_EQ(v.now.clip_from_world, v.now.clip_from_view * v.now.view_from_world);
}

TEST(view, without_jitter_has_the_matrices_of_the_camera_alone)
{
    const View v = make_view(description());
    EXPECT_EQ(v.now.clip_from_view, clip_from_view(90, 2, 0.5f));
    EXPECT_EQ(v.now.view_from_world, view_from_world(v.camera));
    EXPECT_EQ(std::signbit(v.now.clip_from_view[2][0]), false) << "no zero changes its sign";
    EXPECT_EQ(std::signbit(v.now.clip_from_view[2][1]), false);
}

TEST(view, jitter_moves_every_point_by_so_many_pixels_and_no_depth)
{
    ViewDescription d = description();
    const View still = make_view(d);
    d.jitter = {0.25f, -0.375f};
    const View moved = make_view(d);
    for (const vec3& p : {vec3(1, 2, 1), vec3(5, 4, -1), vec3(-40, 9, -60)}) {
        const vec2 by =
            pixel(moved.now.clip_from_world, p, d.render_size) - pixel(still.now.clip_from_world, p, d.render_size);
        EXPECT_NEAR(by.x, 0.25f, 1e-3);
        EXPECT_NEAR(by.y, -0.375f, 1e-3);
        const vec4 a = moved.now.clip_from_world * vec4(p, 1), b = still.now.clip_from_world * vec4(p, 1);
        EXPECT_EQ(a.z, b.z);
        EXPECT_EQ(a.w, b.w);
    }
}

TEST(view, motion_holds_no_jitter)
{
    ViewDescription d = description();
    d.previous_camera.eye.x -= 1; // the camera went 1 m to the right
    d.previous_camera.target.x -= 1;
    const vec3 point(1, 2, -7); // straight ahead, 10 m: 10 pixels of the 100 that 10 m take
    for (const vec2 jitter : {vec2(0), vec2(0.5f, 0.25f), vec2(-0.4f, 0.1f)}) {
        d.jitter = jitter;
        const View v = make_view(d);
        const vec2 motion =
            pixel(v.now.clip_from_world, point, d.render_size) - pixel(v.before.clip_from_world, point, d.render_size);
        EXPECT_NEAR(motion.x, -10, 1e-3);
        EXPECT_NEAR(motion.y, 0, 1e-3);
    }
}

TEST(view, keeps_what_it_is_told_and_is_a_cut_unless_told_otherwise)
{
    EXPECT_TRUE(make_view(ViewDescription{}).cut);
    ViewDescription d = description();
    d.cut = false;
    d.frame_index = 7;
    d.exposure = 2;
    d.previous_exposure = 3;
    d.time = 1.5;
    d.time_step = 0.25;
    d.output_size = {800, 400};
    const View v = make_view(d);
    EXPECT_FALSE(v.cut);
    EXPECT_EQ(v.frame_index, 7u);
    EXPECT_EQ(v.exposure, 2);
    EXPECT_EQ(v.previous_exposure, 3);
    EXPECT_EQ(v.time, 1.5);
    EXPECT_EQ(v.time_step, 0.25);
    EXPECT_EQ(v.output_size, uvec2(800, 400));
    EXPECT_EQ(v.render_size, uvec2(400, 200));
}

} // namespace
} // namespace atrium
