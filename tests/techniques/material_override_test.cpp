// Materials that are changed between frames look as if the scene had been baked with them.

#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

/// A floor with a square of a material of its own 1 m above its middle, seen from above.
BakeData square_over_floor(const Material& material)
{
    truth::SceneBuilder builder;
    const std::uint32_t grey = builder.add_material("grey"), own = builder.add_material(material);
    builder.add_mesh("floor", grey, truth::ground(4));
    builder.add_mesh("square", own, truth::quad({-0.5f, 1, 0.5f}, {1, 0, 0}, {0, 0, -1}));
    return builder.finish();
}

Material red()
{
    Material material;
    material.name = "red";
    material.base_color = {0.5f, 0.1f, 0.1f};
    return material;
}

void look_down(rig::FrameRig& rig)
{
    rig.look({0, 4, 2}, {0, 0.5f, 0});
    rig.light("sun,direction=0.3:-1:0");
    rig.request.want_picture = true;
}

TEST(material_override, looks_as_if_baked_and_goes_back_to_the_byte)
{
    Material wanted = red();
    wanted.cls = MaterialClass::masked;
    wanted.base_color = {0.1f, 0.2f, 0.7f};
    wanted.roughness = 0.25f;
    wanted.metallic = 1;
    Image8 baked;
    {
        rig::FrameRig rig(square_over_floor(wanted));
        look_down(rig);
        baked = rig.render().picture;
    }
    rig::FrameRig rig(square_over_floor(red()));
    look_down(rig);
    const Image8 before = rig.render().picture;
    rig.request.materials = {difference(red(), wanted)};
    EXPECT_EQ(rig.render().picture.values, baked.values);
    rig.request.materials.clear();
    EXPECT_EQ(rig.render().picture.values, before.values);
}

TEST(material_override, light_that_it_emits_is_what_is_seen)
{
    rig::FrameRig rig(square_over_floor(red()));
    rig.look({0, 4, 2}, {0, 1, 0});
    rig.set("ambient.intensity", "0");
    rig.request.want_hdr = true;
    rig.request.materials = {{"r*", {{"emission", "1:2:4"}}}};
    const ImageF hdr = rig.render().hdr;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(hdr.at(160, 90)[c], std::exp2(c), 0.02f); // 9 bits of mantissa
}

TEST(material_override, what_is_all_holes_casts_no_shadow_any_more)
{
    rig::FrameRig rig(square_over_floor(red()));
    look_down(rig);
    const auto darkest = [&] {
        const ImageF visibility = rig.aov("visibility.0");
        return *std::min_element(visibility.values.begin(), visibility.values.end());
    };
    EXPECT_LT(darkest(), 0.5f);
    rig.request.materials = {{"red", {{"class", "masked"}, {"opacity", "0.25"}}}};
    EXPECT_EQ(darkest(), 1.0f);
    rig.request.materials.clear();
    EXPECT_LT(darkest(), 0.5f);
}

TEST(material_outline, lies_on_the_inner_edge_of_the_material)
{
    rig::FrameRig rig(square_over_floor(red()));
    look_down(rig);
    const ImageF material = rig.aov("material");
    const Image8 without = rig.render().picture;
    rig.request.outlined = 1;
    const Image8 with = rig.render().picture;
    int lines = 0;
    for (int y = 2; y < 178; ++y) {
        for (int x = 2; x < 318; ++x) {
            const bool own = *material.at(x, y) == 1;
            const bool inner = *material.at(x - 2, y) == 1 && *material.at(x + 2, y) == 1 &&
                               *material.at(x, y - 2) == 1 && *material.at(x, y + 2) == 1;
            const bool line = !std::equal(with.at(x, y), with.at(x, y) + 3, without.at(x, y));
            ASSERT_EQ(line, own && !inner) << x << ", " << y;
            lines += line ? 1 : 0;
        }
    }
    EXPECT_GT(lines, 200);
}

} // namespace
} // namespace atrium
