// The sky: where there is no geometry, and nowhere else.

#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace atrium {
namespace {

TEST(sky, straight_up_is_the_zenith_and_the_horizon_its_own_colour)
{
    rig::FrameRig rig(truth::floor_scene());
    rig.set("sky.zenith", "0.25:0.5:1");
    rig.set("sky.horizon", "1:1:1");
    rig.look({0, 2, 0}, {0, 10, 0});
    const ImageF up = rig.aov("hdr");
    EXPECT_NEAR(up.at(160, 90)[0], 0.25f, 0.02f); // half a pixel off the zenith
    EXPECT_NEAR(up.at(160, 90)[2], 1.0f, 0.01f);
    // Half way in the sense of the gradient: y = 1/4 gives sqrt(y) = 1/2.
    rig.look({0, 2, 0}, vec3(0, 2, 0) + vec3(0, 0.25f, -std::sqrt(1 - 0.0625f)));
    EXPECT_NEAR(rig.aov("hdr").at(160, 90)[0], 0.625f, 0.01f);
}

TEST(sky, lights_no_pixel_of_geometry)
{
    rig::FrameRig rig(truth::floor_scene());
    rig.set("ambient.intensity", "0");
    rig.look({0, 2, 0}, {0, 1.5f, -2});
    const std::vector<ImageF> got = rig.aovs({"hdr", "material"});
    int floors = 0;
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 320; ++x) {
            const bool floor = *got[1].at(x, y) >= 0;
            ASSERT_EQ(got[0].at(x, y)[2] == 0.0f, floor) << x << "," << y;
            floors += floor ? 1 : 0;
        }
    }
    EXPECT_GT(floors, 10'000);
    EXPECT_LT(floors, 320 * 180 - 10'000);
}

TEST(sky, shows_the_disc_of_a_sun_with_its_radiance)
{
    rig::FrameRig rig(truth::floor_scene());
    rig.set("sky.intensity", "0");
    rig.light("sun,direction=0:-1:0,illuminance=1,angle=10");
    rig.look({0, 2, 0}, {0, 10, 0}, 30);
    const float sine = std::sin(glm::radians(5.0f));
    const ImageF hdr = rig.aov("hdr");
    EXPECT_NEAR(hdr.at(160, 90)[0], 1 / (pi * sine * sine), 0.1f);
    // 5 degrees from the middle: 0.5 tan 5 / tan 15 of the height.
    const int rim = static_cast<int>(90 * std::tan(glm::radians(5.0f)) / std::tan(glm::radians(15.0f)));
    EXPECT_GT(hdr.at(160, 90 - rim + 2)[0], 1);
    EXPECT_EQ(hdr.at(160, 90 - rim - 3)[0], 0);
}

/// A block of 1 m without a floor of its own, seen from the side to which the sun's shadow falls.
struct Block : rig::FrameRig {
    Block() : rig::FrameRig(scene())
    {
        set("ambient.intensity", "0");
        set("sky.floor", "on");
        look({-3, 4, 5}, {-1, 0, 0});
    }
    static BakeData scene()
    {
        truth::SceneBuilder builder;
        builder.add_mesh("block", builder.add_material("grey"), truth::box({-0.5f, 2, -0.5f}, {0.5f, 3, 0.5f}));
        return builder.finish();
    }
    /// Red of `image` where a point of the world is seen.
    [[nodiscard]] float red(const ImageF& image, const vec3& p) const
    {
        const Camera& camera = request.camera;
        const vec4 c = clip_from_view(camera.fov, 16.0f / 9.0f, 0.01f) * view_from_world(camera) * vec4(p, 1);
        return image.at(static_cast<int>(160 * (1 + c.x / c.w)), static_cast<int>(90 * (1 - c.y / c.w)))[0];
    }
};

constexpr float floor_albedo = 0.22f;

TEST(sky, the_floor_takes_the_shadow_of_what_stands_on_it)
{
    // A sun with slope 1/2: the block's shadow reaches 2 m beyond it, farther from the sun than all casters.
    const float lit = floor_albedo / pi * 10 / std::sqrt(5.0f);
    for (const char* filter : {"hard", "pcf", "pcss", "reference"}) {
        Block block;
        block.set("shadow.filter", filter);
        block.light("sun,direction=-2:-1:0,illuminance=10");
        const ImageF hdr = block.aov("hdr");
        const auto red = [&](float x, float z) { return block.red(hdr, {x, 2, z}); };
        for (const float x : {-0.6f, -1.0f, -2.0f, -2.4f}) {
            EXPECT_NEAR(red(x, 0), 0, 0.01f * lit) << filter << " " << x;
            EXPECT_NEAR(red(x, 0.42f), 0, 0.01f * lit) << filter << " " << x;
            EXPECT_NEAR(red(x, 0.6f), lit, 0.01f * lit) << filter << " " << x;
        }
        EXPECT_NEAR(red(-2.65f, 0), lit, 0.01f * lit) << filter;
        EXPECT_NEAR(red(-1.5f, -1.2f), lit, 0.01f * lit) << filter;
        EXPECT_NEAR(red(0.9f, 0.9f), lit, 0.01f * lit) << filter;
    }
}

TEST(sky, the_floor_has_the_light_of_all_kinds_of_lights)
{
    Block block;
    block.light("point,position=-2:4:0,intensity=10"); // the floor is at 2 m: straight below 10 / 2^2
    const auto at_foot = [&] { return block.red(block.aov("hdr"), {-2, 2, 0}); };
    EXPECT_NEAR(at_foot(), floor_albedo / pi * 2.5f, 0.01f);
    block.light("rect,position=-2:12:0,width=1,height=1,radiance=100"); // as good as a point of 100 at 10 m
    EXPECT_NEAR(at_foot(), floor_albedo / pi * 3.5f, 0.01f);
    block.set("ambient.intensity", "1");
    block.set("ambient.sky", "1:1:1");
    EXPECT_NEAR(at_foot(), floor_albedo / pi * 3.5f + floor_albedo, 0.01f);
}

TEST(sky, the_floor_darkens_where_something_stands_on_it)
{
    Block block;
    block.set("ambient.intensity", "1");
    block.set("ambient.sky", "1:1:1");
    block.set("ao.method", "gtao");
    const ImageF hdr = block.aov("hdr");
    EXPECT_NEAR(block.red(hdr, {-1.2f, 2, 1.2f}), floor_albedo, 0.01f);
    // A wall hides half of the hemisphere at its foot, or a little less that is not endless.
    EXPECT_LT(block.red(hdr, {-0.52f, 2, 0.2f}), 0.85f * floor_albedo);
}

TEST(sky, no_line_divides_the_floor_from_the_horizon)
{
    Block block;
    block.light("sun,direction=0:-1:0,illuminance=40"); // much brighter than the horizon
    block.look({0, 5, 8}, {0, 5, 0}, 90);
    const ImageF hdr = block.aov("hdr");
    for (int y = 90; y < 179; ++y) EXPECT_NEAR(hdr.at(20, y)[0], hdr.at(20, y + 1)[0], 0.3f) << y;
    EXPECT_NEAR(hdr.at(20, 90)[0], 1.05f, 0.01f); // sky.horizon
}

TEST(sky, the_floor_is_seen_by_the_picture_and_hdr_alone)
{
    Block block;
    block.light("sun,direction=-2:-1:0.1");
    block.light("spot,position=0:5:0");
    block.set("ao.method", "gtao");
    std::vector<std::string> names;
    for (const AovInfo& info : aov_table()) names.push_back(info.per_light ? std::string(info.name) + ".0" : info.name);
    const std::vector<ImageF> with = block.aovs(names);
    block.set("sky.floor", "off");
    const std::vector<ImageF> without = block.aovs(names);
    for (std::size_t i = 0; i < names.size(); ++i)
        EXPECT_EQ(with[i].values == without[i].values, names[i] != "hdr") << names[i];
}

TEST(sky, no_floor_is_seen_from_below_or_where_the_program_did_not_ask)
{
    Block block;
    block.light("sun,direction=-2:-1:0.1");
    block.set("sky.floor", "off");
    const ImageF above = block.aov("hdr");
    block.set("sky.floor", "auto");
    EXPECT_EQ(block.aov("hdr").values, above.values);
    block.look({-3, 1, 5}, {-1, 0, 0});
    const ImageF below = block.aov("hdr");
    block.set("sky.floor", "on");
    EXPECT_EQ(block.aov("hdr").values, below.values);
}

} // namespace
} // namespace atrium
