// Pictures kept from an earlier day: they tell that something changed, the known answers elsewhere tell what is right.
// Made on lavapipe 25.0.7 (LLVM 15), 320x180, courtyard at low detail with seed 1. Tolerance: of the pixels at most 0.5
// % may differ by more than 6 of 255 (other CPUs round differently at silhouettes). ATRIUM_UPDATE_GOLDENS=1 makes them
// anew.

#include "tests/rig/frame_rig.hpp"
#include "tests/truth/golden.hpp"

#include <gtest/gtest.h>

namespace atrium {
namespace {

constexpr int channel_limit = 6;
constexpr double pixel_share = 0.005;

std::filesystem::path golden(const std::string& name)
{
    return std::filesystem::path(ATRIUM_GOLDENS) / (name + ".png");
}

void expect_golden(rig::FrameRig& rig, const std::string& name)
{
    rig.request.want_picture = true;
    const truth::GoldenResult result =
        truth::compare_golden(rig.render().picture, golden(name), channel_limit, pixel_share);
    EXPECT_TRUE(result.passed) << name << ": " << result.text;
}

struct Court : rig::FrameRig {
    Court() : rig::FrameRig(rig::courtyard_bake())
    {
        set("tonemap.operator", "aces");
        light("sun,direction=-0.4:-1:-0.25,illuminance=4");
        light("point,position=0:3:0,intensity=20,color=1:0.7:0.4");
    }
};

TEST(golden, court_from_its_end)
{
    Court court;
    court.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    expect_golden(court, "court-end");
}

TEST(golden, court_from_above)
{
    Court court;
    court.look({5, 8, 3}, {-4, 1, -2}, 65);
    expect_golden(court, "court-above");
}

TEST(golden, normals_and_materials)
{
    Court court;
    court.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    court.set("debug.view", "normal");
    expect_golden(court, "court-normals");
    court.set("debug.view", "material");
    expect_golden(court, "court-materials");
}

} // namespace
} // namespace atrium
