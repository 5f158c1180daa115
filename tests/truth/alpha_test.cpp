// The mask's arithmetic at known texels.

#include "tests/truth/alpha_map.hpp"
#include "tests/truth/primary.hpp"
#include "tests/truth/scene_builder.hpp"

#include <gtest/gtest.h>

#include <array>

namespace atrium::truth {
namespace {

AlphaMap map_of(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> alpha, bool clamp)
{
    SceneBuilder builder;
    builder.add_alpha_texture(width, height, alpha, clamp);
    const BakeData data = builder.finish();
    return {data.scene.textures[0], data.texels};
}

constexpr std::array<std::uint8_t, 4> quarters{0, 51, 102, 255}; // 0, 0.2 / 0.4, 1

TEST(alpha, texel_centres_stand_at_half_texels)
{
    const AlphaMap map = map_of(2, 2, quarters, false);
    EXPECT_NEAR(map.sample({0.25, 0.25}), 0.0, 1e-12);
    EXPECT_NEAR(map.sample({0.75, 0.25}), 0.2, 1e-12);
    EXPECT_NEAR(map.sample({0.25, 0.75}), 0.4, 1e-12); // v = 0 is the top
    EXPECT_NEAR(map.sample({0.75, 0.75}), 1.0, 1e-12);
    EXPECT_NEAR(map.sample({0.5, 0.5}), 0.4, 1e-12); // the mean of all four
    EXPECT_NEAR(map.sample({0.375, 0.25}), 0.05, 1e-12);
}

TEST(alpha, repeats_or_keeps_its_border)
{
    const AlphaMap repeated = map_of(2, 2, quarters, false), clamped = map_of(2, 2, quarters, true);
    EXPECT_NEAR(repeated.sample({0.0, 0.25}), 0.1, 1e-12); // half of the texel beyond the other end
    EXPECT_NEAR(clamped.sample({0.0, 0.25}), 0.0, 1e-12);
    EXPECT_NEAR(repeated.sample({-0.25, 1.75}), 1.0, 1e-12);
    EXPECT_NEAR(repeated.sample({1000.25, -999.75}), 0.0, 1e-9);
    EXPECT_NEAR(clamped.sample({1e30, 1e30}), 1.0, 1e-12);
    EXPECT_EQ(clamped.sample({std::numeric_limits<double>::quiet_NaN(), 0}), 1.0);
}

TEST(alpha, bc3_blocks_are_decoded)
{
    // End points 200 and 60: seven steps; texel (1, 0) takes code 2 = (6 * 200 + 60) / 7, texel (0, 1) code 1 = 60.
    Texture texture;
    texture.width = texture.height = 4;
    texture.mips = 1;
    texture.format = TextureFormat::bc3_srgb;
    std::array<std::byte, 16> block{std::byte{200}, std::byte{60}, std::byte{2 << 3}, std::byte{1 << 4}};
    texture.size = block.size();
    const AlphaMap map(texture, block);
    EXPECT_NEAR(map.sample({0.125, 0.125}) * 255, 200, 1e-9);
    EXPECT_NEAR(map.sample({0.375, 0.125}) * 255, 180, 1e-9);
    EXPECT_NEAR(map.sample({0.125, 0.375}) * 255, 60, 1e-9);
    // End points the other way round: five steps, and codes 6 and 7 are 0 and 255.
    block = {std::byte{60}, std::byte{200}, std::byte{6 | 7 << 3}};
    const AlphaMap other(texture, block);
    EXPECT_NEAR(other.sample({0.125, 0.125}), 0, 1e-9);
    EXPECT_NEAR(other.sample({0.375, 0.125}), 1, 1e-9);
}

/// Looks at masked_scene's square from 1 m: it fills the picture.
PrimaryBuffers look(const BakeData& data, ivec2 size)
{
    const TempBake bake(data);
    const TruthScene scene(bake.file());
    return cast_primary(scene, {{0, 0, 1}, {0, 0, 0}, 90}, size);
}

TEST(alpha, holes_show_what_is_behind_and_are_flagged)
{
    // Pixels of a 4x4 picture look at u, v = 1/8, 3/8, …; with 4x4 texels, at their centres.
    const std::array<std::uint8_t, 16> alpha{255, 0,   255, 255, //
                                             0,   0,   0,   0,   //
                                             127, 128, 126, 129, //
                                             255, 255, 255, 0};
    const PrimaryBuffers seen = look(masked_scene(4, 4, alpha), {4, 4});
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            const bool solid = alpha[static_cast<std::size_t>(4 * y + x)] >= 128; // 127 / 255 < 0.5
            EXPECT_EQ(*seen.mesh.at(x, y), solid ? 1 : 0) << x << ' ' << y;
            EXPECT_EQ(*seen.material.at(x, y), solid ? 1 : 0) << x << ' ' << y;
            EXPECT_NEAR(*seen.depth.at(x, y), solid ? 1 : 2, 1e-6) << x << ' ' << y;
            EXPECT_TRUE(seen.alpha.at(x, y)) << x << ' ' << y;
        }
    }
    EXPECT_NEAR(seen.uv.at(0, 0)[0], 0.125, 1e-6);
    EXPECT_NEAR(seen.uv.at(0, 0)[1], 0.125, 1e-6);
}

TEST(alpha, nothing_is_flagged_off_the_masked_square)
{
    const std::array<std::uint8_t, 1> solid{255};
    const TempBake bake(masked_scene(1, 1, solid));
    const TruthScene scene(bake.file());
    const PrimaryBuffers seen = cast_primary(scene, {{0, 0, 2}, {0, 0, 0}, 90}, {64, 64});
    EXPECT_NEAR(seen.alpha.share(), 0.25, 1e-9);
    EXPECT_FALSE(seen.alpha.at(8, 32));
    EXPECT_TRUE(seen.alpha.at(32, 32));
    // Seen from behind the wall nothing of the square counts: the wall is culled, the square is two-sided, and further
    // off than the wall would have been.
    const PrimaryBuffers behind = cast_primary(scene, {{0, 0, -3}, {0, 0, 0}, 90}, {64, 64});
    EXPECT_EQ(*behind.mesh.at(32, 32), 1);
    EXPECT_NEAR(*behind.depth.at(32, 32), 3, 1e-6);
    EXPECT_FALSE(behind.surface.at(4, 4));
}

TEST(alpha, a_hole_beyond_the_hit_is_not_flagged)
{
    // A sheet of nothing but hole leans through a wall: nearer than the wall below the middle, behind it above. Its box
    // begins nearer than the wall's, so that rays meet it first wherever they end.
    const std::array<std::uint8_t, 1> hole{0};
    SceneBuilder builder;
    builder.add_mesh("wall", builder.add_material("wall"), quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {4, 4}));
    Material leaf;
    leaf.cls = MaterialClass::masked;
    leaf.base_color_texture = builder.add_alpha_texture(1, 1, hole);
    builder.add_mesh("leaf", builder.add_material(leaf), quad({-2, -2, 0.8f}, {4, 0, 0}, {0, 4, -1.6f}));
    const PrimaryBuffers seen = look(builder.finish(), {8, 8});
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            EXPECT_EQ(*seen.mesh.at(x, y), 0) << x << ' ' << y;
            EXPECT_EQ(seen.alpha.at(x, y), y >= 4) << x << ' ' << y;
        }
    }
}

TEST(alpha, the_opacity_factor_and_the_cutoff_count)
{
    const std::array<std::uint8_t, 1> alpha{153}; // 0.6
    BakeData data = masked_scene(1, 1, alpha, false, 1, 0.5f);
    EXPECT_EQ(*look(data, {1, 1}).mesh.at(0, 0), 1);
    data.scene.materials[1].opacity = 0.8f; // 0.48
    EXPECT_EQ(*look(data, {1, 1}).mesh.at(0, 0), 0);
    data.scene.materials[1].alpha_cutoff = 0.45f;
    EXPECT_EQ(*look(data, {1, 1}).mesh.at(0, 0), 1);
}

} // namespace
} // namespace atrium::truth
