// The sky: where there is no geometry, and nowhere else.

#include "tests/rig/frame_rig.hpp"
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
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 320; ++x) {
            const bool floor = *got[1].at(x, y) >= 0;
            ASSERT_EQ(got[0].at(x, y)[2] == 0.0f, floor) << x << "," << y;
        }
    }
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

} // namespace
} // namespace atrium
