#include "assetconv/mips.hpp"

#include "assetconv/block_compression.hpp"
#include "assetconv/dilate.hpp"
#include "assetconv/srgb.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace atrium {
namespace {

constexpr std::uint32_t any_size = 16384;

template <class Texel>
PackedImage image(int width, int height, int channels, Texel&& texel)
{
    PackedImage out{width, height, channels, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int k = 0; k < channels; ++k) out.texels.push_back(static_cast<std::uint8_t>(texel(x, y, k)));
        }
    }
    return out;
}

TEST(srgb, encodes_to_the_nearest_code)
{
    for (int c = 0; c < 256; ++c) EXPECT_EQ(srgb_encode8(srgb_decode_table()[static_cast<std::size_t>(c)]), c);
    for (int i = 0; i <= 100000; ++i) {
        const float x = static_cast<float>(i) / 100000;
        const double wanted = srgb_encode(x) * 255.0;
        ASSERT_LE(std::abs(srgb_encode8(x) - wanted), 0.501) << x;
    }
    EXPECT_EQ(srgb_encode8(-1), 0);
    EXPECT_EQ(srgb_encode8(NAN), 0);
    EXPECT_EQ(srgb_encode8(2), 255);
}

TEST(mips, colour_is_averaged_in_linear_light)
{
    const auto board = [](int x, int y, int k) { return k == 3 ? 255 : (x + y) % 2 == 0 ? 255 : 0; };
    const auto levels = build_mips(image(4, 4, 4, board), MipSpace::srgb_color, {}, any_size);
    ASSERT_EQ(levels.size(), 3u);
    for (std::size_t i = 1; i < 3; ++i) EXPECT_EQ(levels[i].texels[0], 188); // half the light, not half the code
    const auto mixed = [](int x, int, int k) { return k == 3 ? 255 : x % 2 == 0 ? 100 : 200; };
    const auto mean = build_mips(image(2, 2, 4, mixed), MipSpace::srgb_color, {}, any_size);
    EXPECT_EQ(mean[1].texels[0], 160); // .1274 and .5776 of light; the codes' mean is 150
    const auto data = build_mips(image(4, 4, 4, board), MipSpace::data, {}, any_size);
    EXPECT_EQ(data[1].texels[0], 128);
}

TEST(mips, odd_sizes_keep_the_mean)
{
    std::mt19937 random(4);
    const PackedImage noise = image(13, 7, 4, [&](int, int, int) { return random() % 256; });
    double mean = 0;
    for (std::size_t i = 0; i < noise.texels.size(); i += 4) mean += noise.texels[i] / (13.0 * 7.0);
    const auto levels = build_mips(noise, MipSpace::data, {}, any_size);
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_EQ(levels[1].width, 6u);
    EXPECT_EQ(levels[1].height, 3u);
    EXPECT_EQ(levels[3].width, 1u);
    EXPECT_NEAR(levels[3].texels[0], mean, 0.51); // every texel weighs the same
}

TEST(mips, the_size_limit_leaves_out_the_first_levels)
{
    const auto grey = [](int, int, int) { return 100; };
    const auto levels = build_mips(image(64, 16, 4, grey), MipSpace::data, {}, 20);
    EXPECT_EQ(levels.front().width, 16u);
    EXPECT_EQ(levels.front().height, 4u);
    EXPECT_EQ(levels.size(), 5u);
}

TEST(mips, normals_are_averaged_as_vectors)
{
    // Columns tilted left and right by 60 degrees average to the surface's own normal, at full length.
    const auto tilted = [](int x, int, int k) { return k == 1 ? 128 : x % 2 == 0 ? 238 : 17; };
    const auto levels = build_mips(image(8, 8, 2, tilted), MipSpace::normals, {}, any_size);
    EXPECT_NEAR(levels[1].texels[0], 127.5, 1);
    // Three flat texels and one tilted by 90 degrees to the right: (1, 0, 3) normalised, not (0.25, …).
    const auto mixed = [](int x, int y, int k) { return k == 0 && x == 0 && y == 0 ? 255 : 128; };
    const auto small = build_mips(image(2, 2, 2, mixed), MipSpace::normals, {}, any_size);
    EXPECT_NEAR(small[1].texels[0] / 127.5 - 1, 1 / std::sqrt(10.0), 0.01);
}

TEST(dilate, hidden_texels_take_the_colour_of_visible_ones)
{
    PackedImage leaf = image(16, 16, 4, [](int x, int y, int k) {
        const bool visible = x >= 6 && x < 10 && y >= 6 && y < 10;
        return k == 3 ? (visible ? 255 : 0) : visible ? (k == 1 ? 180 : 40) : 255;
    });
    dilate_color(leaf, 128);
    for (std::size_t i = 0; i < leaf.texels.size(); i += 4) {
        EXPECT_NEAR(leaf.texels[i], 40, 1);
        EXPECT_NEAR(leaf.texels[i + 1], 180, 1);
    }
}

/// Decodes one BC1 colour block by the format's definition.
std::array<vec3, 16> decode_bc1(const std::uint8_t* b)
{
    const auto color = [](unsigned c) {
        return vec3(static_cast<float>(c >> 11) * 255 / 31, static_cast<float>(c >> 5 & 63) * 255 / 63,
                    static_cast<float>(c & 31) * 255 / 31);
    };
    const unsigned c0 = b[0] | b[1] << 8, c1 = b[2] | b[3] << 8;
    EXPECT_GE(c0, c1);
    const std::array<vec3, 4> palette{color(c0), color(c1), (2.0f * color(c0) + color(c1)) / 3.0f,
                                      (color(c0) + 2.0f * color(c1)) / 3.0f};
    std::array<vec3, 16> out;
    for (std::size_t i = 0; i < 16; ++i) out[i] = palette[b[4 + i / 4] >> (2 * (i % 4)) & 3];
    return out;
}

TEST(block_compression, gradients_survive)
{
    MipLevel level{4, 4, {}};
    for (int i = 0; i < 16; ++i)
        level.texels.insert(level.texels.end(),
                            {static_cast<std::uint8_t>(i * 16), static_cast<std::uint8_t>(255 - i * 16), 60, 255});
    const auto block = compress_level(level, TextureFormat::bc1_srgb);
    ASSERT_EQ(block.size(), 8u);
    const auto decoded = decode_bc1(block.data());
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_NEAR(decoded[i].x, static_cast<float>(i) * 16, 45); // four steps for sixteen values
        EXPECT_NEAR(decoded[i].z, 60, 6);
    }
}

TEST(block_compression, normals_and_alpha_are_within_a_step)
{
    MipLevel level{4, 4, {}};
    for (int i = 0; i < 16; ++i)
        level.texels.insert(level.texels.end(),
                            {static_cast<std::uint8_t>(100 + i * 3), static_cast<std::uint8_t>(200 - i)});
    const auto blocks = compress_level(level, TextureFormat::bc5_unorm);
    ASSERT_EQ(blocks.size(), 16u);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < 6; ++i) bits |= std::uint64_t{blocks[2 + i]} << (8 * i);
    const int a0 = blocks[0], a1 = blocks[1];
    EXPECT_EQ(a0, 145);
    EXPECT_EQ(a1, 100);
    for (int i = 0; i < 16; ++i) {
        const auto code = static_cast<int>(bits >> (3 * i) & 7);
        const double value = code == 0 ? a0 : code == 1 ? a1 : ((8 - code) * a0 + (code - 1) * a1) / 7.0;
        EXPECT_NEAR(value, 100 + i * 3, 45 / 14.0 + 0.01);
    }
}

TEST(block_compression, blocks_cover_odd_sizes)
{
    const MipLevel level{5, 3, std::vector<std::uint8_t>(5 * 3 * 4, 77)};
    EXPECT_EQ(compress_level(level, TextureFormat::bc3_srgb).size(), mip_bytes(TextureFormat::bc3_srgb, 5, 3));
}

} // namespace
} // namespace atrium
