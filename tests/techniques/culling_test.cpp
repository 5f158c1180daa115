// Culling leaves the picture as it is, and leaves work out.

#include "renderer/core/error.hpp"
#include "renderer/graph/runner.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>
#include <random>

namespace atrium {
namespace {

constexpr std::array kinds{"culling.frustum", "culling.cone", "culling.occlusion", "culling.triangles"};

void set_culling(rig::FrameRig& rig, bool on)
{
    for (const char* kind : kinds) rig.set(kind, on ? "on" : "off");
}

/// Points of a scene's bounds, the same each time.
class RandomPoints {
public:
    RandomPoints(const rig::FrameRig& rig, unsigned seed) : bounds_(rig.bake().scene().bounds), random_(seed) {}
    float unit() { return unit_(random_); }
    vec3 next()
    {
        const float x = unit(), y = unit(), z = unit();
        return bounds_.min + bounds_.extent() * vec3(x, y, z);
    }
    vec3 step() { return next() - bounds_.centre(); } ///< as far as half the scene

private:
    Bounds bounds_;
    std::mt19937 random_;
    std::uniform_real_distribution<float> unit_{0, 1};
};

/// Cameras that jump, each followed by one that stepped aside: what was seen before is wrong at once, then nearly
/// right.
void expect_no_pixel_changed(rig::FrameRig& rig, int cameras)
{
    RandomPoints points(rig, 11);
    vec3 eye(0), target(0);
    float fov = 60;
    for (int i = 0; i < cameras; ++i) {
        if (i % 2 == 0) {
            eye = points.next();
            target = points.next();
            fov = 20 + 100 * points.unit();
        } else {
            eye += 0.01f * points.step();
        }
        rig.look(eye, target, fov);
        set_culling(rig, true);
        const std::vector<ImageF> culled = rig.aovs({"depth", "mesh", "albedo"});
        set_culling(rig, false);
        const std::vector<ImageF> whole = rig.aovs({"depth", "mesh", "albedo"});
        for (std::size_t k = 0; k < culled.size(); ++k)
            ASSERT_EQ(culled[k].values, whole[k].values) << "camera " << i << ", AOV " << k;
    }
}

TEST(culling, changes_no_pixel_over_random_cameras_and_cuts)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.size = {97, 55}; // cells of the depth pyramid that the picture fills in part
    expect_no_pixel_changed(rig, 200);
}

TEST(culling, changes_no_pixel_of_sponza)
{
    const auto bake = rig::sponza_bake();
    if (!bake) GTEST_SKIP() << "ATRIUM_SCENES names no folder of real scenes";
    rig::FrameRig rig(*bake);
    rig.request.size = {97, 55};
    expect_no_pixel_changed(rig, 60);
}

TEST(culling, each_kind_leaves_out_more)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.want_statistics = true;
    rig.look({-8, 1.7f, -5}, {8, 2.5f, 2}, 40); // out of an aisle, between columns
    set_culling(rig, false);
    std::uint64_t drawn = rig.render().triangles;
    EXPECT_EQ(drawn, rig.bake().scene().index_count / 3);
    for (const char* kind : kinds) {
        rig.set(kind, "on");
        const std::uint64_t fewer = rig.render().triangles;
        EXPECT_LT(fewer, drawn) << kind;
        drawn = fewer;
    }
}

TEST(culling, a_wall_hides_what_stands_behind_it)
{
    truth::SceneBuilder builder;
    const std::uint32_t grey = builder.add_material("grey");
    builder.add_mesh("wall", grey, truth::quad({-4, -3, 0}, {8, 0, 0}, {0, 6, 0}));
    for (int i = 0; i < 5; ++i)
        builder.add_mesh("ball" + std::to_string(i), grey, truth::sphere({i - 2, 0, -3}, 0.5f, 32));
    rig::FrameRig rig(builder.finish());
    rig.request.want_statistics = true;
    rig.look({0, 0, 4}, {0, 0, 0});
    for (const char* triangles : {"off", "on"}) {
        rig.set("culling.triangles", triangles);
        rig.set("culling.occlusion", "off");
        EXPECT_GT(rig.render().triangles, 500u);
        rig.set("culling.occlusion", "on");
        EXPECT_EQ(rig.render().triangles, 2u); // the wall's
    }
    rig.look({0, 4, -3}, {0, 0, -3.1f}); // a cut to behind the wall
    EXPECT_GT(rig.render().triangles, 500u);
}

/// Walks with cuts, each frame with what the one before saw; at times with other kinds of culling in between.
void expect_memory_hides_nothing(rig::FrameRig& rig, int frames)
{
    RandomPoints points(rig, 5);
    vec3 eye(0), target(0);
    std::size_t pixels = 0, others = 0;
    for (int i = 0; i < frames; ++i) {
        if (i % 8 == 0) {
            eye = points.next();
            target = points.next();
        } else {
            eye += 0.01f * points.step();
        }
        rig.look(eye, target, 70);
        rig.set("culling.occlusion", i % 16 == 5 ? "off" : "on");
        rig.set("culling.triangles", i % 16 == 12 ? "off" : "on");
        rig.request.remember = false;
        const std::vector<ImageF> fresh = rig.aovs({"depth", "mesh"});
        rig.request.remember = true;
        const std::vector<ImageF> remembered = rig.aovs({"depth", "mesh"});
        ASSERT_EQ(remembered[0].values, fresh[0].values) << "frame " << i;
        for (std::size_t p = 0; p < fresh[1].values.size(); ++p) {
            ++pixels;
            others += fresh[1].values[p] != remembered[1].values[p] ? 1 : 0;
        }
    }
    EXPECT_LE(others, pixels / 1000); // surfaces at the same depth
}

TEST(culling, memory_hides_nothing)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.size = {97, 55};
    expect_memory_hides_nothing(rig, 160);
}

TEST(culling, memory_hides_nothing_of_sponza)
{
    const auto bake = rig::sponza_bake();
    if (!bake) GTEST_SKIP() << "ATRIUM_SCENES names no folder of real scenes";
    rig::FrameRig rig(*bake);
    rig.request.size = {97, 55};
    expect_memory_hides_nothing(rig, 64);
}

TEST(culling, a_still_camera_remembers_the_same_picture_and_draws_less)
{
    rig::FrameRig rig(rig::courtyard_bake());
    set_culling(rig, true);
    rig.request.want_picture = rig.request.want_statistics = true;
    rig.look({-8, 1.7f, -5}, {8, 2.5f, 2}, 40);
    const FrameResult fresh = rig.render();
    rig.request.remember = true;
    for (int frame = 0; frame < 8; ++frame) EXPECT_EQ(rig.render().picture.values, fresh.picture.values);
    EXPECT_LT(rig.render().triangles, 0.9 * static_cast<double>(fresh.triangles));
    rig.set("culling.triangles", "off"); // forgets nothing that it must know
    EXPECT_EQ(rig.render().picture.values, fresh.picture.values);
    rig.set("culling.triangles", "on");
    EXPECT_EQ(rig.render().picture.values, fresh.picture.values);
}

TEST(culling, a_frame_that_fails_is_not_remembered)
{
    rig::FrameRig rig(rig::courtyard_bake());
    set_culling(rig, true);
    rig.look({-8, 1.7f, -5}, {8, 2.5f, 2}, 40);
    const ImageF fresh = rig.aov("depth");
    rig.request.remember = true;
    rig.set("debug.view", "dpeth");
    EXPECT_THROW(static_cast<void>(rig.render()), Error);
    rig.set("debug.view", "");
    EXPECT_EQ(rig.aov("depth").values, fresh.values);
    EXPECT_EQ(rig.aov("depth").values, fresh.values);
}

TEST(culling, more_clusters_than_a_dispatch_has_groups)
{
    rig::FrameRig rig(truth::floor_scene());
    SceneDescription scene;
    scene.bakes.push_back(&rig.bake());
    for (int i = 0; i < 66'000; ++i) // every device has 65,535 groups, lavapipe no more
        scene.instances.push_back(
            {0, std::nullopt, glm::translate(mat4(1), vec3(0, -0.01f * static_cast<float>(i), 0))});
    rig::engine().load(scene);
    rig.request.size = {64, 36};
    rig.look({0, 2, 0}, {0, 0, -2});
    set_culling(rig, true);
    EXPECT_EQ(*rig.aov("instance").at(32, 20), 0); // and validation says nothing (rig)
}

TEST(draws, bind_once_per_class_and_draw_at_most_once_per_material)
{
    rig::FrameRig rig(rig::courtyard_bake());
    for (const graph::PassStats& pass : rig.render().stats.passes) {
        if (pass.name != "gbuffer") continue;
        EXPECT_LE(pass.pipeline_binds, 4u);
        EXPECT_LE(pass.draws, rig.bake().scene().materials.size());
    }
}

TEST(draws, the_same_frame_twice_gives_the_same_bytes)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.want_picture = rig.request.want_hdr = true;
    rig.light("sun");
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    const FrameResult first = rig.render(), second = rig.render();
    EXPECT_EQ(first.picture.values, second.picture.values);
    EXPECT_EQ(first.hdr.values, second.hdr.values);
}

} // namespace
} // namespace atrium
