// A masked fence has the same solid area at a distance as in its finest mip.

#include "tests/rig/frame_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace atrium {
namespace {

/// A square of 2 m in z = 0 under a map_d of bars 8 texels wide, 64 apart: hard, or ramps of 6 texels on either side.
std::filesystem::path fence(const std::string& name, bool soft, const std::string& options)
{
    const std::filesystem::path folder = rig::temporary_folder();
    Image8 bars(512, 512, 3);
    for (int y = 0; y < 512; ++y) {
        for (int x = 0; x < 512; ++x) {
            const auto bar = [&](int i) {
                const int outside = std::max(std::abs(2 * (i % 64) - 31) - 7, 0) / 2;
                return soft ? std::max(255 - outside * 40, 0) : outside == 0 ? 255 : 0;
            };
            std::fill_n(bars.at(x, y), 3, static_cast<std::uint8_t>(std::max(bar(x), bar(y))));
        }
    }
    write_png(folder / (name + ".png"), bars);
    std::ofstream(folder / (name + ".mtl")) << "newmtl fence\n" << options << "\nmap_d " << name << ".png\n";
    std::ofstream(folder / (name + ".obj")) << "mtllib " << name
                                            << ".mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                               "vt 0 1\nusemtl fence\nf 1/1 2/2 3/3 4/4\n";
    return rig::bake_of(folder / (name + ".obj"));
}

/// Solid pixels of several pictures from `direction`, each moved by a part of a pixel, so that bars of a pixel's width
/// do not beat against the grid.
int solid_pixels(rig::FrameRig& rig, const vec3& direction, float distance)
{
    int solid = 0;
    for (int i = 0; i < 6; ++i) {
        const auto part = [&](float step) { return std::fmod(static_cast<float>(i) * step, 1.0f) * 0.25f; };
        const vec3 shift(part(0.7549f), part(0.5698f), 0);
        rig.look(direction * distance + shift, shift, 30);
        const ImageF material = rig.aov("material");
        solid += static_cast<int>(std::count(material.values.begin(), material.values.end(), 0.0f));
    }
    return solid;
}

void expect_as_solid_as_mip_0(rig::FrameRig& rig, const std::string& name)
{
    const vec3 from_the_side = glm::normalize(vec3(1.5f, 0.4f, 1));
    for (const vec3& direction : {vec3(0, 0, 1), from_the_side}) {
        for (const float distance : {2.0f, 4.0f, 8.0f, 12.0f, 20.0f}) {
            rig.set("debug.alpha_lod0", "on");
            const int wanted = solid_pixels(rig, direction, distance);
            rig.set("debug.alpha_lod0", "off");
            const int got = solid_pixels(rig, direction, distance);
            EXPECT_GT(wanted, 500) << name; // enough to speak of shares
            EXPECT_NEAR(got, wanted, 0.15 * wanted) << name << " at " << distance << " m, x " << direction.x;
        }
    }
}

TEST(mask, a_fence_is_as_solid_at_a_distance_as_its_finest_mip)
{
    rig::FrameRig rig(fence("hard", false, ""));
    for (const char* anisotropy : {"1", "8"}) {
        rig.set("texture.anisotropy", anisotropy);
        expect_as_solid_as_mip_0(rig, std::string("anisotropy ") + anisotropy);
    }
}

TEST(mask, a_hard_fence_stays_so_at_other_cutoffs)
{
    rig::FrameRig rig(fence("cut", false, ""));
    for (const char* cutoff : {"0.25", "0.75"}) {
        rig.request.materials = {{"fence", {{"alpha_cutoff", cutoff}}}};
        expect_as_solid_as_mip_0(rig, std::string("cutoff ") + cutoff);
    }
}

TEST(mask, a_soft_fence_stays_so_with_an_opacity_of_its_own)
{
    rig::FrameRig rig(fence("soft", true, "d 0.7"));
    expect_as_solid_as_mip_0(rig, "soft");
}

} // namespace
} // namespace atrium
