#include "renderer/scene/scene.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace atrium {
namespace {

TEST(scene, names_of_classes_and_formats)
{
    EXPECT_STREQ(to_string(MaterialClass::opaque), "opaque");
    EXPECT_STREQ(to_string(MaterialClass::masked), "masked");
    EXPECT_STREQ(to_string(MaterialClass::blended), "blended");
    EXPECT_STREQ(to_string(MaterialClass::cloth), "cloth");
    std::set<std::string> names;
    for (int f = 0; f <= static_cast<int>(TextureFormat::bc5_unorm); ++f) {
        names.insert(to_string(static_cast<TextureFormat>(f)));
    }
    EXPECT_EQ(names.size(), 8u);
    EXPECT_EQ(names.count("?"), 0u);
}

TEST(scene, which_formats_are_block_compressed)
{
    EXPECT_FALSE(is_block_compressed(TextureFormat::rgba8_srgb));
    EXPECT_FALSE(is_block_compressed(TextureFormat::r8_unorm));
    EXPECT_TRUE(is_block_compressed(TextureFormat::bc1_srgb));
    EXPECT_TRUE(is_block_compressed(TextureFormat::bc5_unorm));
}

TEST(scene, bytes_of_a_mip_level)
{
    EXPECT_EQ(mip_bytes(TextureFormat::rgba8_srgb, 5, 3), 60u);
    EXPECT_EQ(mip_bytes(TextureFormat::rgba8_unorm, 1, 1), 4u);
    EXPECT_EQ(mip_bytes(TextureFormat::rg8_unorm, 5, 3), 30u);
    EXPECT_EQ(mip_bytes(TextureFormat::r8_unorm, 5, 3), 15u);
    EXPECT_EQ(mip_bytes(TextureFormat::bc1_srgb, 8, 8), 32u); // 4 blocks of 8 bytes
    EXPECT_EQ(mip_bytes(TextureFormat::bc1_srgb, 1, 1), 8u);
    EXPECT_EQ(mip_bytes(TextureFormat::bc3_unorm, 5, 4), 32u); // 2 blocks of 16 bytes
    EXPECT_EQ(mip_bytes(TextureFormat::bc5_unorm, 4, 4), 16u);
    EXPECT_EQ(mip_bytes(TextureFormat::rgba8_unorm, 65536, 65536), std::uint64_t{1} << 34); // beyond 32 bits
}

TEST(scene, mips_start_at_multiples_of_the_alignment)
{
    // 4x2 RGBA: 32 bytes, then 2x1: 8 in 16, then 1x1: 4 in 16.
    EXPECT_EQ(mip_offsets(TextureFormat::rgba8_unorm, 4, 2, 3), (std::vector<std::uint64_t>{0, 32, 48, 64}));
    // 8x8 BC1: 32 bytes; 4x4, 2x2 and 1x1: one block of 8 in 16.
    EXPECT_EQ(mip_offsets(TextureFormat::bc1_srgb, 8, 8, 4), (std::vector<std::uint64_t>{0, 32, 48, 64, 80}));
    EXPECT_EQ(mip_offsets(TextureFormat::r8_unorm, 1, 1, 0), (std::vector<std::uint64_t>{0}));
}

} // namespace
} // namespace atrium
