// Culling leaves the picture as it is, and leaves work out.

#include "renderer/graph/runner.hpp"
#include "tests/rig/frame_rig.hpp"

#include <gtest/gtest.h>

#include <random>

namespace atrium {
namespace {

void set_culling(rig::FrameRig& rig, bool on)
{
    rig.set("culling.frustum", on ? "on" : "off");
    rig.set("culling.cone", on ? "on" : "off");
}

TEST(culling, changes_no_pixel_over_random_cameras)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.size = {96, 54};
    const Bounds& b = rig.bake().scene().bounds;
    std::mt19937 random(11);
    std::uniform_real_distribution<float> unit(0, 1);
    const auto point = [&] { return b.min + b.extent() * vec3(unit(random), unit(random), unit(random)); };
    for (int i = 0; i < 60; ++i) {
        rig.look(point(), point(), 20 + 100 * unit(random));
        set_culling(rig, true);
        const std::vector<ImageF> culled = rig.aovs({"depth", "mesh", "albedo"});
        set_culling(rig, false);
        const std::vector<ImageF> whole = rig.aovs({"depth", "mesh", "albedo"});
        for (std::size_t k = 0; k < culled.size(); ++k)
            ASSERT_EQ(culled[k].values, whole[k].values) << "camera " << i << ", AOV " << k;
    }
}

TEST(culling, leaves_out_what_is_behind_and_what_faces_away)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.want_statistics = true;
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    set_culling(rig, false);
    const std::uint64_t all = rig.render().triangles;
    EXPECT_EQ(all, rig.bake().scene().index_count / 3);
    rig.set("culling.frustum", "on");
    const std::uint64_t in_view = rig.render().triangles;
    EXPECT_LT(in_view, all);
    rig.set("culling.cone", "on");
    EXPECT_LT(rig.render().triangles, in_view);
    rig.look({-8, 1.7f, 0.5f}, {-100, 1.7f, 0.5f}); // out of the court, at its end wall
    EXPECT_LT(rig.render().triangles, all / 4);
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
