// Triangles wound against their normals are lit on the side of the normals.

#include "tests/rig/frame_rig.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>

namespace atrium {
namespace {

/// A ball of radius 1 over a floor, with one normal a vertex; every other face wound against them, or none.
std::filesystem::path ball(const std::string& name, bool mixed)
{
    constexpr int rings = 16, slices = 24;
    std::string text = "v -3 -1.2 3\nv 3 -1.2 3\nv 3 -1.2 -3\nv -3 -1.2 -3\nvn 0 1 0\n";
    for (int j = 0; j <= rings; ++j) {
        for (int i = 0; i < slices; ++i) {
            const float a = 3.1415927f * static_cast<float>(j) / rings, b = 6.2831853f * static_cast<float>(i) / slices;
            const vec3 p(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
            text += fmt::format("v {0} {1} {2}\nvn {0} {1} {2}\n", p.x, p.y, p.z);
        }
    }
    text += "g floor\nf 1//1 2//1 3//1 4//1\ng ball\n";
    const auto triangle = [&](std::array<int, 3> c, bool turned) {
        if (turned) std::swap(c[1], c[2]);
        text += fmt::format("f {}//{} {}//{} {}//{}\n", c[0] + 4, c[0] + 1, c[1] + 4, c[1] + 1, c[2] + 4, c[2] + 1);
    };
    for (int j = 0, face = 0; j < rings; ++j) {
        for (int i = 0; i < slices; ++i, ++face) {
            const auto at = [&](int row, int column) { return row * slices + column % slices + 1; };
            const bool turned = mixed && face % 2 == 0;
            if (j > 0) triangle({at(j, i), at(j, i + 1), at(j + 1, i)}, turned);
            if (j < rings - 1) triangle({at(j, i + 1), at(j + 1, i + 1), at(j + 1, i)}, turned);
        }
    }
    const std::filesystem::path file = rig::temporary_folder() / (name + ".obj");
    std::ofstream(file) << text;
    return rig::bake_of(file);
}

std::vector<std::vector<ImageF>> pictures(const std::filesystem::path& bake)
{
    rig::FrameRig rig(bake);
    rig.set("shadow.filter", "hard");
    rig.light("sun,direction=-1:-2:-0.5,illuminance=3");
    std::vector<std::vector<ImageF>> all;
    for (const vec3& eye : {vec3(3, 1, 0.5f), vec3(-2, 1, 2), vec3(0.3f, 3, 1), vec3(0, 0.5f, -3)}) {
        rig.look(eye, vec3(0), 50);
        all.push_back(rig.aovs({"normal", "geometric_normal", "hdr"}));
    }
    return all;
}

TEST(winding, a_ball_of_mixed_winding_is_lit_like_one_wound_right)
{
    const auto right = pictures(ball("right", false)), mixed = pictures(ball("mixed", true));
    for (std::size_t view = 0; view < right.size(); ++view) {
        for (std::size_t k = 0; k < right[view].size(); ++k) {
            const ImageF &a = right[view][k], &b = mixed[view][k];
            int off = 0;
            for (std::size_t i = 0; i < a.values.size(); ++i)
                off += std::abs(a.values[i] - b.values[i]) > 2e-3f ? 1 : 0;
            // Of the silhouette a pixel or two may show the back of an edge, because the mesh is drawn two-sided.
            EXPECT_LE(off, 12) << view << " " << k;
        }
    }
}

} // namespace
} // namespace atrium
