// Masks cover the same area in every mip, as a sampler filters it: between texels and between levels.

#include "assetconv/mips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace atrium {
namespace {

constexpr std::uint32_t any_size = 16384;

template <class Alpha>
PackedImage mask(int width, int height, Alpha&& alpha)
{
    PackedImage out{width, height, 4, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            out.texels.insert(out.texels.end(), {30, 140, 20, static_cast<std::uint8_t>(alpha(x, y))});
        }
    }
    return out;
}

/// Bilinear alpha, 0 to 1, as Vulkan defines it.
double sample(const MipLevel& level, bool clamp, double u, double v)
{
    const int width = static_cast<int>(level.width), height = static_cast<int>(level.height);
    const double x = u * width - 0.5, y = v * height - 0.5;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const auto wrap = [&](int i, int n) { return clamp ? std::clamp(i, 0, n - 1) : (i + n) % n; };
    const auto at = [&](int i, int j) {
        return level.texels[static_cast<std::size_t>(wrap(j, height) * width + wrap(i, width)) * 4 + 3] / 255.0;
    };
    const double fx = x - x0, fy = y - y0;
    return std::lerp(std::lerp(at(x0, y0), at(x0 + 1, y0), fx), std::lerp(at(x0, y0 + 1), at(x0 + 1, y0 + 1), fx), fy);
}

/// Share of the plane that is solid where `share` of the coarser level is mixed in: by many samples.
double sampled_area(const MipLevel& fine, const MipLevel& coarse, double share, const MaskTest& test)
{
    constexpr int points = 150000; // of a Fibonacci lattice: no two in a row or a column
    int solid = 0;
    for (int i = 0; i < points; ++i) {
        const double u = i * 0.6180339887498949 - std::floor(i * 0.6180339887498949), v = (i + 0.5) / points;
        const double a = sample(fine, test.clamp, u, v);
        const double alpha = share > 0 ? std::lerp(a, sample(coarse, test.clamp, u, v), share) : a;
        solid += alpha >= static_cast<double>(test.cutoff) ? 1 : 0;
    }
    return static_cast<double>(solid) / points;
}

MaskLevel<std::uint8_t> alpha_of(const MipLevel& level)
{
    MaskLevel<std::uint8_t> out{static_cast<int>(level.width), static_cast<int>(level.height), {}};
    for (std::size_t i = 3; i < level.texels.size(); i += 4) out.alpha.push_back(level.texels[i]);
    return out;
}

TEST(mask_mips, the_area_of_one_texel_is_known)
{
    // (1 - x)(1 - y) >= 1/2 in each of four quarters: 1/2 - ln 2 / 2 of a texel.
    MaskLevel<std::uint8_t> level{4, 4, std::vector<std::uint8_t>(16, 0)};
    level.alpha[5] = 255;
    EXPECT_NEAR(covered_area(level, {0.5f, false}), 4 * (0.5 - 0.5 * std::log(2.0)) / 16, 1e-4);
    // In a corner, clamped: the whole quarter towards the corner and half a texel each way along the edges.
    level.alpha[5] = 0;
    level.alpha[0] = 255;
    EXPECT_NEAR(covered_area(level, {0.5f, true}), (0.25 + 0.5 + 0.5 - 0.5 * std::log(2.0)) / 16, 1e-4);
    EXPECT_NEAR(covered_area(level, {0.5f, false}), 4 * (0.5 - 0.5 * std::log(2.0)) / 16, 1e-4); // it is round again
}

TEST(mask_mips, areas_are_what_samples_count)
{
    std::mt19937 random(7);
    for (const bool clamp : {false, true}) {
        for (const float cutoff : {0.2f, 0.5f, 0.8f}) {
            const PackedImage noise = mask(13, 9, [&](int, int) { return random() % 256; });
            const MipLevel level{13, 9, noise.texels};
            const MaskTest test{cutoff, clamp};
            EXPECT_NEAR(covered_area(alpha_of(level), test), sampled_area(level, level, 0, test), 0.002);
        }
    }
}

struct Case {
    const char* name;
    PackedImage image;
    MaskTest test;
    std::size_t levels; ///< how many keep the mask
};

std::vector<Case> cases()
{
    std::mt19937 random(5);
    const auto fence = [](int x, int y) { return x % 64 < 8 || y % 64 < 8 ? 255 : 0; };
    const auto soft_fence = [](int x, int y) {
        return std::clamp(std::max(180 - 20 * std::abs(x % 64 - 9), 180 - 20 * std::abs(y % 64 - 9)), 0, 255);
    };
    const auto disc = [](int x, int y) {
        return std::clamp(255 * (100 - std::hypot(x - 128, y - 128)) / 40, 0.0, 255.0);
    };
    const auto board = [](int side) { return [side](int x, int y) { return (x / side + y / side) % 2 ? 255 : 0; }; };
    const auto half = [](int x, int) { return x < 37 ? 255 : 0; };
    return {{"fence", mask(512, 512, fence), {0.5f, false}, 5},
            {"clamped fence", mask(512, 512, fence), {0.5f, true}, 5},
            {"fence, high cutoff", mask(512, 512, fence), {0.7f, false}, 5},
            {"fence, low cutoff", mask(512, 512, fence), {0.3f, false}, 5},
            {"soft fence", mask(512, 512, soft_fence), {0.5f, false}, 4},
            {"odd fence", mask(200, 75, [](int x, int y) { return x % 20 < 3 || y % 15 < 2 ? 255 : 0; }), {}, 3},
            {"thin lines", mask(256, 256, [](int x, int) { return x % 16 == 0 ? 255 : 0; }), {}, 2},
            {"thin slanting lines", mask(256, 256, [](int x, int y) { return (x + y) % 32 == 0 ? 255 : 0; }), {}, 2},
            {"board of single texels", mask(64, 64, board(1)), {}, 1},
            {"board", mask(64, 64, board(8)), {}, 4},
            {"dots", mask(256, 256, [](int x, int y) { return x % 16 == 3 && y % 16 == 5 ? 255 : 0; }), {}, 1},
            {"leaves", mask(256, 256, [&](int, int) { return random() % 3 == 0 ? 255 : 0; }), {}, 1},
            {"disc", mask(256, 256, disc), {0.5f, true}, 7},
            {"half", mask(128, 64, half), {0.5f, false}, 7}};
}

TEST(mask_mips, every_level_and_what_lies_between_two_covers_as_much_as_the_finest)
{
    for (const Case& c : cases()) {
        const auto levels = build_mips(c.image, MipSpace::srgb_color, c.test, any_size);
        EXPECT_GE(levels.size(), c.levels) << c.name;
        const double wanted = covered_area(alpha_of(levels[0]), c.test), rare = std::min(wanted, 1 - wanted);
        for (std::size_t i = 1; i < levels.size(); ++i) {
            EXPECT_NEAR(covered_area(alpha_of(levels[i]), c.test), wanted, rare * 0.03) << c.name << " " << i;
            for (const double share : {0.25, 0.5, 0.75}) {
                const double area = sampled_area(levels[i - 1], levels[i], share, c.test);
                EXPECT_NEAR(area, wanted, rare * 0.12) << c.name << " " << i << " " << share;
            }
        }
    }
}

TEST(mask_mips, shrunk_masks_cover_as_much_as_the_finest)
{
    const PackedImage fence = mask(256, 256, [](int x, int y) { return x % 32 < 4 || y % 32 < 4 ? 255 : 0; });
    const MaskTest test{0.5f, false};
    const double wanted = covered_area(alpha_of({256, 256, fence.texels}), test);
    const auto levels = build_mips(fence, MipSpace::srgb_color, test, 32);
    ASSERT_EQ(levels[0].width, 32u);
    for (const MipLevel& level : levels) EXPECT_NEAR(covered_area(alpha_of(level), test), wanted, 0.03 * wanted);
    EXPECT_EQ(build_mips(fence, MipSpace::srgb_color, test, 1).size(), 1u); // flat, but there must be one
}

TEST(mask_mips, masks_without_holes_or_without_anything_stay_so)
{
    for (const int alpha : {255, 0}) {
        const auto levels =
            build_mips(mask(8, 8, [&](int, int) { return alpha; }), MipSpace::srgb_color, MaskTest{}, any_size);
        EXPECT_EQ(levels.size(), 4u);
        for (const MipLevel& level : levels)
            EXPECT_EQ(covered_area(alpha_of(level), MaskTest{}), alpha == 255 ? 1.0 : 0.0);
    }
}

} // namespace
} // namespace atrium
