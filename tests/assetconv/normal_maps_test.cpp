#include "assetconv/normal_maps.hpp"

#include "bake_rig.hpp"

#include <random>

namespace atrium {
namespace {

/// Hills and a wall: smooth, periodic, different along both axes.
float hills(float x, float y)
{
    return 6 * std::sin(x * 0.19635f) * std::cos(y * 0.0981748f) + 3 * std::sin((x + y) * 0.294524f);
}

/// The normal map of hills(), 128 x 128; `green` +1 up, -1 down; `noise` in codes.
SourceImage normal_map(float green, int noise = 0)
{
    SourceImage image;
    image.width = image.height = 128;
    image.channels = 3;
    std::mt19937 random(6);
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 128; ++x) {
            const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
            const float dx = (hills(fx + 1, fy) - hills(fx - 1, fy)) / 2,
                        dy = (hills(fx, fy + 1) - hills(fx, fy - 1)) / 2;
            const vec3 n = glm::normalize(vec3(-dx, green * dy, 1));
            for (int k = 0; k < 3; ++k) {
                const int jitter =
                    noise == 0 ? 0 : static_cast<int>(random() % static_cast<unsigned>(2 * noise + 1)) - noise;
                image.bytes.push_back(static_cast<std::uint8_t>(
                    std::clamp(static_cast<int>((n[k] * 0.5f + 0.5f) * 255 + 0.5f) + jitter, 0, 255)));
            }
        }
    }
    gather_facts(image);
    return image;
}

SourceImage grey(int width, int height, const std::function<float(int, int)>& value)
{
    SourceImage image;
    image.width = width;
    image.height = height;
    image.channels = 1;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image.words.push_back(static_cast<std::uint16_t>(value(x, y) * 65535 + 0.5f));
    }
    gather_facts(image);
    return image;
}

TEST(normal_maps, are_told_from_heights_and_pictures)
{
    EXPECT_EQ(classify_bump(normal_map(1)), BumpContent::normals);
    EXPECT_EQ(classify_bump(normal_map(-1, 6)), BumpContent::normals);
    EXPECT_EQ(classify_bump(grey(16, 16, [](int x, int) { return static_cast<float>(x) / 16; })), BumpContent::height);
    SourceImage picture = normal_map(1);
    for (std::size_t i = 0; i < picture.bytes.size(); i += 3)
        std::swap(picture.bytes[i], picture.bytes[i + 2]); // bricks, say
    gather_facts(picture);
    EXPECT_EQ(classify_bump(picture), BumpContent::colour);
    SourceImage islands = normal_map(1);
    for (std::size_t i = 0; i < islands.bytes.size() / 2; ++i) islands.bytes[i] = 0; // black outside of the islands
    gather_facts(islands);
    EXPECT_EQ(classify_bump(islands), BumpContent::normals);
    const NormalField field = read_normals(islands);
    EXPECT_FALSE(field.valid.front());
    EXPECT_EQ(field.normals.front(), vec3(0, 0, 1));
    EXPECT_TRUE(field.valid.back());
}

TEST(normal_maps, green_is_found_by_the_curl_both_ways)
{
    for (const int noise : {0, 6}) {
        EXPECT_EQ(green_axis_by_curl(read_normals(normal_map(1, noise))), GreenAxis::up) << noise;
        EXPECT_EQ(green_axis_by_curl(read_normals(normal_map(-1, noise))), GreenAxis::down) << noise;
    }
}

TEST(normal_maps, a_map_without_curl_is_decided_by_the_colours_or_not_at_all)
{
    // Waves along y only: both signs are free of curl.
    const auto waves = [](float green) {
        SourceImage image = normal_map(green);
        for (int y = 0; y < 128; ++y) {
            for (int x = 0; x < 128; ++x) {
                const vec3 n = glm::normalize(vec3(0, green * std::cos(static_cast<float>(y) * 0.0981748f), 1));
                for (int k = 0; k < 3; ++k)
                    image.bytes[static_cast<std::size_t>((y * 128 + x) * 3 + k)] =
                        static_cast<std::uint8_t>((n[k] * 0.5f + 0.5f) * 255 + 0.5f);
            }
        }
        return image;
    };
    // dh/dy = cos, so h = sin: bright where high.
    const SourceImage colour = grey(
        32, 32, [](int, int y) { return 0.5f + 0.4f * std::sin((static_cast<float>(y) + 0.5f) * 4 * 0.0981748f); });
    const SourceImage plain = grey(32, 32, [](int, int) { return 0.5f; });
    for (const float green : {1.0f, -1.0f}) {
        const NormalField field = read_normals(waves(green));
        EXPECT_FALSE(green_axis_by_curl(field));
        EXPECT_EQ(green_axis_by_colour(field, colour), green > 0 ? GreenAxis::up : GreenAxis::down);
        EXPECT_FALSE(green_axis_by_colour(field, plain));
    }
}

TEST(normal_maps, heights_become_slopes_without_curl)
{
    const SourceImage height =
        grey(128, 128, [](int x, int y) { return 0.5f + 0.03f * hills(static_cast<float>(x), static_cast<float>(y)); });
    const std::vector<vec3> normals = normals_from_height(height, 'l', 20, false);
    // White is 128/128 texel x 20 above black: slope 20 x dh/dx.
    const auto at = [&](int x, int y) { return normals[static_cast<std::size_t>(y * 128 + x)]; };
    const float slope = 20 * 0.03f * (hills(41, 20) - hills(39, 20)) / 2;
    EXPECT_NEAR(-at(40, 20).x / at(40, 20).z, slope, 0.02f * std::abs(slope) + 0.005f);
    const float down = 20 * 0.03f * (hills(40, 21) - hills(40, 19)) / 2;
    EXPECT_NEAR(at(40, 20).y / at(40, 20).z, down, 0.02f * std::abs(down) + 0.005f); // green up
    NormalField field{128, 128, normals, std::vector<bool>(normals.size(), true)};
    EXPECT_EQ(green_axis_by_curl(field), GreenAxis::up);
}

TEST(normal_maps, a_flat_height_is_the_surface_itself)
{
    for (const vec3& n : normals_from_height(grey(8, 8, [](int, int) { return 0.3f; }), 'l', 5, false))
        EXPECT_EQ(n, vec3(0, 0, 1));
}

/// The whole way: a green-down map comes out green up, unless told otherwise.
TEST(normal_maps, the_bake_turns_green_up)
{
    const test::Folder folder;
    for (const float green : {1.0f, -1.0f}) {
        const SourceImage map = normal_map(green);
        folder.write_image("n.png", 128, 128, 3, [&](int x, int y) {
            const std::uint8_t* t = &map.bytes[static_cast<std::size_t>((y * 128 + x) * 3)];
            return test::Rgb{t[0], t[1], t[2]};
        });
        const BakeData bake = test::bake_material(folder, "map_bump n.png\n");
        const std::int32_t normal = bake.scene.materials.at(0).normal_texture;
        ASSERT_GE(normal, 0);
        const float dy = (hills(40, 21) - hills(40, 19)) / 2, dx = (hills(41, 20) - hills(39, 20)) / 2;
        const vec3 n = glm::normalize(vec3(-dx, dy, 1));
        EXPECT_NEAR(test::texel(bake, normal, 0, 40, 20, 0) / 127.5 - 1, n.x, 0.02);
        EXPECT_NEAR(test::texel(bake, normal, 0, 40, 20, 1) / 127.5 - 1, n.y, 0.02);
        BakeOptions up;
        up.normal_y = NormalY::up;
        const BakeData as_is = test::bake_material(folder, "map_bump n.png\n", up);
        EXPECT_NEAR(test::texel(as_is, normal, 0, 40, 20, 1) / 127.5 - 1, green * n.y, 0.02);
    }
}

} // namespace
} // namespace atrium
