// A frame's view and its lights as pictures show them: jitter, and lights that come and go.

#include "renderer/graph/runner.hpp"
#include "renderer/scene/view.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace atrium {
namespace {

void begin(rig::FrameRig& rig)
{
    rig.look({3, 2, 4}, {0, 0.3f, 0}, 50);
    rig.light("point,position=1:3:1,name=a");
}

TEST(frame_view, with_jitter_a_pixel_sees_what_lies_as_far_beside_it)
{
    rig::FrameRig rig(truth::box_on_floor());
    begin(rig);
    rig.request.jitter = {0.5f, -0.25f};
    ViewDescription still;
    still.camera = rig.request.camera;
    still.render_size = rig.request.size;
    const mat4 clip_from_world = make_view(still).now.clip_from_world;
    const ImageF position = rig.aov("position"), depth = rig.aov("depth");
    int seen = 0;
    for (int y = 0; y < position.height; ++y) {
        for (int x = 0; x < position.width; ++x) {
            if (!std::isfinite(*depth.at(x, y))) continue;
            const float* p = position.at(x, y);
            const vec4 clip = clip_from_world * vec4(p[0], p[1], p[2], 1);
            const vec2 at = (vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * vec2(rig.request.size);
            ASSERT_NEAR(at.x, static_cast<float>(x) + 0.5f - 0.5f, 0.02f) << x << "," << y;
            ASSERT_NEAR(at.y, static_cast<float>(y) + 0.5f + 0.25f, 0.02f) << x << "," << y;
            ++seen;
        }
    }
    EXPECT_GT(seen, 10000);
}

TEST(frame_view, jitter_does_not_move_what_stands)
{
    rig::FrameRig rig(truth::box_on_floor());
    begin(rig);
    rig.request.jitter = {0.5f, -0.25f};
    const ImageF motion = rig.aov("motion");
    for (const float v : motion.values) ASSERT_NEAR(v, 0, 1e-6f) << "a pixel is 3e-3";
}

TEST(frame_view, by_whole_pixels_jitter_moves_the_picture_and_culling_follows)
{
    rig::FrameRig rig(truth::box_on_floor());
    begin(rig);
    rig.set("ao.method", "ssao");
    const std::vector<std::string> names{"mesh", "hdr", "ao"};
    const std::vector<ImageF> still = rig.aovs(names);
    constexpr int right = 64, down = 16; // far enough to show a side that an unmoved frustum leaves out
    rig.request.jitter = {right, down};
    const std::vector<ImageF> moved = rig.aovs(names);
    int differ = 0;
    for (int y = down; y < 180; ++y) {
        for (int x = right; x < 320; ++x) {
            ASSERT_EQ(*moved[0].at(x, y), *still[0].at(x - right, y - down)) << x << "," << y;
            if (std::abs(*moved[1].at(x, y) - *still[1].at(x - right, y - down)) > 1e-2f) ++differ;
        }
    }
    EXPECT_LT(differ, 50) << "edges of shadows and faces may round the other way";
    for (const char* kind : {"culling.frustum", "culling.occlusion", "culling.triangles"}) rig.set(kind, "off");
    EXPECT_EQ(rig.aov("mesh").values, moved[0].values);
}

/// Passes of the last frame that drew shadow maps.
std::set<std::string> drawn_maps(const rig::FrameRig& rig)
{
    std::set<std::string> out;
    for (const graph::PassStats& pass : rig.render().stats.passes) {
        const std::string& name = pass.name;
        if (name.starts_with("shadow.") && name.find('.', 7) == std::string::npos) out.insert(name);
    }
    return out;
}

TEST(frame_view, a_light_removed_in_the_middle_leaves_the_maps_of_the_others)
{
    rig::FrameRig rig(truth::box_on_floor());
    rig.set("shadow.resolution", "128");
    rig.look({3, 2, 4}, {0, 0.3f, 0}, 50);
    for (const char* spec : {"point,position=1:3:1,name=a", "spot,position=-2:3:1,direction=2:-3:-1,name=b",
                             "spot,position=2:3:2,direction=-2:-3:-2,name=c", "sun,name=d"})
        rig.light(spec);
    EXPECT_EQ(drawn_maps(rig), (std::set<std::string>{"shadow.0", "shadow.1", "shadow.2", "shadow.3"}));
    EXPECT_EQ(drawn_maps(rig), std::set<std::string>{});
    rig.request.lights.erase(rig.request.lights.begin() + 1);
    EXPECT_EQ(drawn_maps(rig), std::set<std::string>{}) << "none of them has changed";
    const ImageF kept = rig.aov("hdr");
    rig.set("shadow.cache", "off");
    EXPECT_EQ(rig.aov("hdr").values, kept.values) << "as with maps drawn again";
    rig.set("shadow.cache", "on");
    rig.light("spot,position=-2:3:1,direction=2:-3:-1,name=e");
    static_cast<void>(rig.render());
    rig.request.lights.insert(rig.request.lights.begin(), parse_light("point,position=0:2:2,name=f"));
    rig.set("shadow.max_lights", "8");
    EXPECT_EQ(drawn_maps(rig), std::set<std::string>{"shadow.0"}) << "the new one alone";
}

} // namespace
} // namespace atrium
