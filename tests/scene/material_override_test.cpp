#include "renderer/scene/material_override.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace atrium {
namespace {

Material named(const std::string& name)
{
    Material material;
    material.name = name;
    return material;
}

TEST(material_override, a_difference_makes_one_material_of_the_other)
{
    const Material from = named("a");
    Material to = from;
    to.cls = MaterialClass::blended;
    to.two_sided = true;
    to.base_color = {0.1f, 1.0f / 3.0f, 1};
    to.opacity = 0.3f;
    to.alpha_cutoff = 0.1f + 0.2f;
    to.roughness = 0;
    to.metallic = 1;
    to.specular = 1e-7f;
    to.emission = {0, 123.456f, 1e8f};
    const MaterialOverride o = difference(from, to);
    EXPECT_EQ(o.values.size(), 9u); // all that is described
    EXPECT_TRUE(difference(to, overridden(from, {&o, 1})).values.empty());
    EXPECT_TRUE(difference(from, from).values.empty());
}

TEST(material_override, a_bake_s_values_may_lie_beyond_the_ranges)
{
    Material odd = named("odd");
    odd.roughness = 7;
    odd.emission = vec3(-1);
    const MaterialOverride o{"odd", {{"metallic", "0.5"}}};
    const Material after = overridden(odd, {&o, 1});
    EXPECT_EQ(after.roughness, 7);
    EXPECT_EQ(after.metallic, 0.5f);
    EXPECT_EQ(difference(odd, after), o);
}

TEST(material_override, names_that_no_toml_can_hold_still_match)
{
    for (const char* name : {"plain", "K\xe4se", "two\nlines", "star*", "a\"b\\c"})
        EXPECT_TRUE(matches_pattern(pattern_of(name), name)) << name;
    EXPECT_EQ(pattern_of("K\xe4se\x7f\n"), "K?se??");
}

TEST(material_override, patterns_are_spelled_out_name_by_name)
{
    const std::vector<Material> materials{named("cloth_a"), named("stone"), named("cloth_b"), named("cloth_a")};
    const std::vector<MaterialOverride> patterns{{"cloth*", {{"roughness", "0.5"}}},
                                                 {"*_b", {{"roughness", "1"}, {"metallic", "1"}}}};
    const std::vector<MaterialOverride> expected{{"cloth_a", {{"roughness", "0.5"}}}, {"cloth_b", {{"metallic", "1"}}}};
    EXPECT_EQ(spelled_out(materials, patterns), expected);
}

} // namespace
} // namespace atrium
