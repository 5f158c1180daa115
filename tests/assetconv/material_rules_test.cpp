// One test for each row of the table in docs/materials.md.

#include "bake_rig.hpp"

#include "assetconv/texture_recipe.hpp"
#include "renderer/core/error.hpp"

namespace atrium {
namespace {

using test::bake_material;
using test::Folder;
using test::Rgb;
using test::Rgba;
using test::texel;
using test::warnings_of;

class MaterialRules : public testing::Test {
protected:
    MaterialRules()
    {
        folder_.write_image("color.png", 4, 4, 3, [](int x, int y) { return Rgb{10 + x * 50, 20 + y * 50, 30}; });
        folder_.write_image("grey.png", 4, 4, 1, [](int x, int y) { return std::array<int, 1>{(x + y * 4) * 17}; });
        folder_.write_image("mask.png", 8, 8, 1, [](int x, int) { return std::array<int, 1>{x < 4 ? 255 : 0}; });
        folder_.write_image("leaf.png", 8, 8, 4, [](int x, int y) {
            return Rgba{60, 120, 30, (x + y) % 2 == 0 ? 255 : 0};
        });
        folder_.write_image("solid.png", 4, 4, 4, [](int, int) { return Rgba{60, 120, 30, 255}; });
        folder_.write_image("empty.png", 4, 4, 4, [](int, int) { return Rgba{60, 120, 30, 0}; });
        folder_.write_image("half.png", 4, 4, 1, [](int, int) { return std::array<int, 1>{128}; });
        folder_.write_image("smoke.png", 4, 4, 4, [](int x, int) { return Rgba{99, 99, 99, x * 20}; });
    }
    Material bake(const std::string& mtl)
    {
        last_ = bake_material(folder_, mtl);
        return last_.scene.materials.at(0);
    }
    Folder folder_;
    BakeData last_;
};

void expect_color(const vec3& actual, const vec3& expected)
{
    EXPECT_LT(glm::distance(actual, expected), 1e-5f) << actual.x << " " << actual.y << " " << actual.z;
}

TEST_F(MaterialRules, kd_alone_is_the_base_colour)
{
    expect_color(bake("Kd 0.2 0.4 0.6\n").base_color, {0.2f, 0.4f, 0.6f});
    expect_color(bake("illum 2\n").base_color, vec3(0.8f));
}

TEST_F(MaterialRules, a_neutral_kd_leaves_the_map_alone_a_colour_multiplies)
{
    for (const char* kd : {"0.588 0.588 0.588", "0.4704 0.4704 0.4704", "0.64 0.64 0.64", "0 0 0"})
        expect_color(bake(std::string("Kd ") + kd + "\nmap_Kd color.png\n").base_color, vec3(1));
    const Material m = bake("Kd 0.5 0.25 1\nmap_Kd color.png\n");
    expect_color(m.base_color, {0.5f, 0.25f, 1});
    ASSERT_EQ(last_.scene.textures.at(0).format, TextureFormat::rgba8_srgb);
    EXPECT_EQ(texel(last_, m.base_color_texture, 0, 2, 1, 0), 110); // codes as in the file, top row first
    EXPECT_EQ(texel(last_, m.base_color_texture, 0, 2, 1, 1), 70);
    EXPECT_EQ(texel(last_, m.base_color_texture, 0, 2, 1, 3), 255);
}

TEST_F(MaterialRules, ka_is_no_light_and_map_ka_only_a_stand_in)
{
    expect_color(bake("Ka 1 0 0\nKd 0.5 0.5 0.5\n").base_color, vec3(0.5f));
    EXPECT_EQ(bake("map_Ka color.png\nmap_Kd grey.png\n").base_color_texture, 0);
    EXPECT_EQ(last_.scene.textures.at(0).file, "grey.png");
    EXPECT_EQ(bake("map_Ka color.png\n").base_color_texture, 0);
}

TEST_F(MaterialRules, ks_gives_the_dielectric_f0)
{
    EXPECT_FLOAT_EQ(bake("illum 1\nKs 1 1 1\n").specular, 0.04f);
    EXPECT_FLOAT_EQ(bake("illum 2\nKs 0 0 0\n").specular, 0.04f); // not "no specular"
    EXPECT_FLOAT_EQ(bake("illum 2\nKs 1 1 1\n").specular, 0.08f);
    EXPECT_FLOAT_EQ(bake("illum 2\nKs 0.5 0.5 0.5\n").specular, 0.04f);
    EXPECT_FLOAT_EQ(bake("illum 2\nKs 0.1 0.1 0.1\n").specular, 0.02f);
}

TEST_F(MaterialRules, map_ks_scales_f0_and_roughness)
{
    const Material m = bake("illum 2\nNs 10\nmap_Ks grey.png\n");
    EXPECT_FLOAT_EQ(m.specular, 0.04f);
    EXPECT_FLOAT_EQ(m.roughness, 1);
    EXPECT_EQ(last_.scene.textures.at(0).format, TextureFormat::rgba8_unorm);
    EXPECT_EQ(texel(last_, m.surface_texture, 0, 3, 3, 0), 255);
    EXPECT_NEAR(texel(last_, m.surface_texture, 0, 3, 3, 1) / 255.0, 0.6389, 0.002); // r where the map is white
    EXPECT_EQ(texel(last_, m.surface_texture, 0, 0, 0, 0), 0);
    EXPECT_NEAR(texel(last_, m.surface_texture, 0, 0, 0, 1) / 255.0, 0.8389, 0.002); // r + .2 where it is black
    EXPECT_EQ(texel(last_, m.surface_texture, 0, 1, 1, 2), 255);                     // no metal: the factor says so
    EXPECT_FLOAT_EQ(m.metallic, 0);
}

TEST_F(MaterialRules, a_constant_map_becomes_a_factor)
{
    const Material m = bake("illum 2\nNs 10\nmap_Ks half.png\n");
    EXPECT_EQ(m.surface_texture, no_texture);
    EXPECT_NEAR(m.specular, 0.04 * 128 / 255, 1e-5);
    EXPECT_NEAR(m.roughness, 0.6389 + 0.2 * 127 / 255, 1e-3);
    EXPECT_NEAR(bake("Pr 0.5\nmap_Pr half.png\n").roughness, 0.5 * 128 / 255, 1e-5);
}

TEST_F(MaterialRules, coloured_ks_on_dark_kd_is_a_metal)
{
    const Material gold = bake("illum 2\nKd 0.02 0.02 0.02\nKs 0.9 0.7 0.2\n");
    EXPECT_FLOAT_EQ(gold.metallic, 1);
    expect_color(gold.base_color, {0.9f, 0.7f, 0.2f});
    EXPECT_FLOAT_EQ(bake("illum 2\nKd 0 0 0\nKs 0.6 0.6 0.6\n").metallic, 1); // bright enough without colour
    EXPECT_FLOAT_EQ(bake("illum 2\nKd 0 0 0\nKs 0.3 0.3 0.3\n").metallic, 0);
    EXPECT_FLOAT_EQ(bake("illum 2\nKd 0.5 0.5 0.5\nKs 0.9 0.7 0.2\n").metallic, 0);
    EXPECT_FLOAT_EQ(bake("illum 2\nKd 0 0 0\nKs 0.9 0.7 0.2\nPm 0\n").metallic, 0); // Pm knows better
    EXPECT_FLOAT_EQ(bake("illum 2\nKd 0 0 0\nKs 0.9 0.7 0.2\nmap_Kd color.png\n").metallic, 0);
}

TEST_F(MaterialRules, ns_becomes_roughness)
{
    // alpha = sqrt(2 / (Ns + 2)), r = sqrt(alpha)
    for (const auto& [ns, r] :
         {std::pair{7.843, 0.6714}, {10.0, 0.6389}, {100.0, 0.3742}, {1000.0, 0.2114}, {0.0, 1.0}})
        EXPECT_NEAR(bake("illum 2\nNs " + std::to_string(ns) + "\n").roughness, r, 5e-5) << ns;
    EXPECT_FLOAT_EQ(bake("illum 1\nNs 100\n").roughness, 1);
    EXPECT_FLOAT_EQ(bake("illum 0\nNs 100\n").roughness, 1);
    EXPECT_FLOAT_EQ(bake("Kd 1 1 1\n").roughness, 1);
}

TEST_F(MaterialRules, map_ns_multiplies_the_exponent)
{
    const Material m = bake("illum 2\nNs 100\nmap_Ns grey.png\n");
    EXPECT_FLOAT_EQ(m.roughness, 1);
    EXPECT_NEAR(texel(last_, m.surface_texture, 0, 3, 3, 1) / 255.0, 0.3742, 0.002);
    EXPECT_NEAR(texel(last_, m.surface_texture, 0, 0, 0, 1) / 255.0, 1.0, 0.002);
    EXPECT_NEAR(texel(last_, m.surface_texture, 0, 0, 1, 1) / 255.0, roughness_of_exponent(100.0f * 68 / 255), 0.002);
    EXPECT_EQ(texel(last_, m.surface_texture, 0, 0, 0, 0), 255);
}

TEST_F(MaterialRules, ni_gives_f0_unless_it_is_the_exporters_one)
{
    EXPECT_FLOAT_EQ(bake("illum 2\nNi 1.5\n").specular, 0.04f);
    EXPECT_NEAR(bake("illum 2\nNi 1.8\n").specular, 0.0816f, 1e-4f);
    EXPECT_FLOAT_EQ(bake("illum 2\nNi 1\n").specular, 0.04f);
    EXPECT_FLOAT_EQ(bake("illum 2\nNi 40\n").specular, 0.04f);
}

TEST_F(MaterialRules, d_below_one_blends)
{
    const Material m = bake("d 0.25\n");
    EXPECT_EQ(m.cls, MaterialClass::blended);
    EXPECT_FLOAT_EQ(m.opacity, 0.25f);
    EXPECT_TRUE(m.two_sided);
    EXPECT_TRUE(last_.scene.meshes.at(0).two_sided);
    EXPECT_EQ(bake("d 1\n").cls, MaterialClass::opaque);
    EXPECT_FALSE(last_.scene.meshes.at(0).two_sided);
    EXPECT_FLOAT_EQ(bake("Tr 0.75\n").opacity, 0.25f);
}

TEST_F(MaterialRules, nothing_is_invisible)
{
    EXPECT_EQ(bake("d 0\n").cls, MaterialClass::opaque);
    EXPECT_EQ(warnings_of(last_, "mtl-invisible"), 1u);
    EXPECT_EQ(bake("d 1.0\nTr 0.0\n").cls, MaterialClass::opaque); // both, meaning the same
    EXPECT_EQ(bake("d 1.0\nTr 1.0\n").cls, MaterialClass::opaque); // both, contradicting: d wins
    EXPECT_EQ(bake("Tr 1\n").cls, MaterialClass::opaque);          // written the wrong way round
    EXPECT_EQ(warnings_of(last_, "mtl-invisible"), 0u);
    EXPECT_EQ(bake("map_Kd empty.png\n").cls, MaterialClass::opaque); // an alpha channel that nobody filled
    const Material masked = bake("d 0\nmap_d mask.png\n");
    EXPECT_EQ(masked.cls, MaterialClass::masked);
    EXPECT_FLOAT_EQ(masked.opacity, 1);
}

TEST_F(MaterialRules, map_d_masks_by_luminance)
{
    const Material m = bake("map_Kd color.png\nmap_d mask.png\n");
    EXPECT_EQ(m.cls, MaterialClass::masked);
    EXPECT_TRUE(m.two_sided);
    EXPECT_FLOAT_EQ(m.alpha_cutoff, 0.5f);
    const Texture& t = last_.scene.textures.at(0);
    EXPECT_EQ(t.file, "color.png+mask.png");
    EXPECT_EQ(t.width, 8u); // the larger of the two
    EXPECT_EQ(texel(last_, 0, 0, 1, 1, 3), 255);
    EXPECT_EQ(texel(last_, 0, 0, 6, 1, 3), 0);
}

TEST_F(MaterialRules, a_mask_may_be_an_alpha_channel)
{
    EXPECT_EQ(bake("map_Kd leaf.png\nmap_d leaf.png\n").cls, MaterialClass::masked); // the same file twice
    EXPECT_EQ(texel(last_, 0, 0, 0, 0, 3), 255);
    EXPECT_EQ(texel(last_, 0, 0, 1, 0, 3), 0);
    EXPECT_EQ(texel(last_, 0, 0, 1, 0, 1), 120); // colour grows into the hole
    EXPECT_EQ(last_.scene.textures.at(0).file, "leaf.png");
    EXPECT_EQ(bake("map_Kd leaf.png\n").cls, MaterialClass::masked); // no map_d at all
    EXPECT_EQ(bake("map_Kd solid.png\n").cls, MaterialClass::opaque);
    EXPECT_EQ(bake("map_Kd smoke.png\n").cls, MaterialClass::blended); // as a mask it would vanish
}

TEST_F(MaterialRules, ke_and_map_ke_emit)
{
    expect_color(bake("Ke 36 33 24\n").emission, {36, 33, 24});
    const Material m = bake("Ke 2 2 2\nmap_Ke color.png\n");
    expect_color(m.emission, vec3(2));
    EXPECT_EQ(last_.scene.textures.at(static_cast<std::size_t>(m.emission_texture)).format, TextureFormat::rgba8_srgb);
    expect_color(bake("Ke 0 0 0\nmap_Ke color.png\n").emission, vec3(1));
    expect_color(bake("Ke 0 0 0\n").emission, vec3(0));
}

TEST_F(MaterialRules, pr_and_pm_override)
{
    const Material m = bake("illum 2\nNs 10\nPr 0.2\nPm 0.3\n");
    EXPECT_FLOAT_EQ(m.roughness, 0.2f);
    EXPECT_FLOAT_EQ(m.metallic, 0.3f);
    const Material maps = bake("illum 2\nNs 10\nmap_Ks grey.png\nmap_Pr grey.png\nPm 0.5\nmap_Pm grey.png\n");
    EXPECT_FLOAT_EQ(maps.roughness, 1); // factor 1 if absent
    EXPECT_FLOAT_EQ(maps.metallic, 0.5f);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(texel(last_, maps.surface_texture, 0, 1, 1, k), 85); // linear, as they are
}

TEST_F(MaterialRules, glass_needs_a_reason)
{
    EXPECT_EQ(bake("illum 4\n").cls, MaterialClass::opaque);
    EXPECT_EQ(bake("illum 4\nTf 1 1 1\n").cls, MaterialClass::opaque); // what exporters write everywhere
    EXPECT_EQ(bake("illum 4\nTf 0.5 0.5 0.5\n").cls, MaterialClass::blended);
    EXPECT_EQ(bake("illum 2\nTf 0.5 0.5 0.5\n").cls, MaterialClass::opaque);
}

TEST_F(MaterialRules, bump_maps_become_normals)
{
    const Material m = bake("bump -bm 4 grey.png\n");
    ASSERT_GE(m.normal_texture, 0);
    EXPECT_EQ(last_.scene.textures.at(0).format, TextureFormat::rg8_unorm);
    EXPECT_EQ(bake("bump half.png\n").normal_texture, no_texture); // no slopes
    EXPECT_GE(bake("map_disp grey.png\n").normal_texture, 0);
    bake("bump color.png\n");
    EXPECT_EQ(warnings_of(last_, "bump-colour"), 1u);
}

TEST_F(MaterialRules, map_options_reach_the_texels)
{
    EXPECT_EQ(texel((bake("map_Kd -mm 0.2 0.5 solid.png\n"), last_), 0, 0, 0, 0, 1), 111); // 120 / 2 + 51
    EXPECT_TRUE((bake("map_Kd -clamp on color.png\n"), last_).scene.textures.at(0).clamp);
    bake("map_Pr -imfchan g color.png\n");
    EXPECT_EQ(texel(last_, 0, 0, 2, 1, 1), 70);
    bake("map_Kd -s 2 2 color.png\nmap_Ks grey.png\n");
    EXPECT_EQ(warnings_of(last_, "map-transform"), 1u);
}

TEST_F(MaterialRules, equal_recipes_share_a_texture)
{
    folder_.write("two.mtl", "newmtl a\nmap_Kd color.png\nKd 1 0 0\nnewmtl b\nmap_Kd color.png\nnewmtl c\nmap_Kd "
                             "color.png\nmap_d mask.png\n");
    BakeOptions options;
    options.input = folder_.write("two.obj", "mtllib two.mtl\n" + test::square + "usemtl a\n" + test::square_face +
                                                 "usemtl b\n" + test::square_face + "usemtl c\n" + test::square_face);
    const BakeData bake = bake_scene(options);
    EXPECT_EQ(bake.scene.textures.size(), 2u);
    EXPECT_EQ(bake.scene.materials[0].base_color_texture, bake.scene.materials[1].base_color_texture);
}

TEST_F(MaterialRules, missing_textures_warn_with_their_place_or_fail)
{
    const Material m = bake("Kd 0 0 0\nmap_Kd textures\\gone.png\n");
    EXPECT_EQ(m.base_color_texture, no_texture);
    expect_color(m.base_color, vec3(0.8f));
    ASSERT_EQ(warnings_of(last_, "texture-missing"), 1u);
    EXPECT_NE(last_.scene.warnings[0].first.find("m.mtl:3, map_Kd of material \"m\""), std::string::npos);
    folder_.write("broken.png", "this is no picture");
    bake("map_Kd broken.png\n");
    EXPECT_EQ(warnings_of(last_, "texture-unreadable"), 1u);
    BakeOptions strict;
    strict.strict = true;
    EXPECT_THROW((void)bake_material(folder_, "map_Kd gone.png\n", strict), Error);
    EXPECT_THROW((void)bake_material(folder_, "map_Kd broken.png\n", strict), Error);
}

} // namespace
} // namespace atrium
