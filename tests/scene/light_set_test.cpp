// A frame's lights: their order on the device, which cast shadows, and their keys from frame to frame.

#include "renderer/scene/light_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace atrium {
namespace {

Light light(LightType type, const std::string& name = "", bool shadow = true)
{
    Light out = default_light(type);
    out.name = name;
    out.shadow = shadow;
    return out;
}

TEST(light_set, puts_lights_with_area_behind_the_others)
{
    const std::vector<Light> lights{light(LightType::rect), light(LightType::point), light(LightType::rect),
                                    light(LightType::sun), light(LightType::spot)};
    const LightSet set = make_light_set(lights, 16);
    EXPECT_EQ(set.places, (std::vector<std::uint32_t>{3, 0, 4, 1, 2}));
    EXPECT_EQ(set.delta_count, 3u);
    EXPECT_EQ(set.lights.data(), lights.data());
}

TEST(light_set, gives_shadow_layers_to_the_first_that_cast_shadows)
{
    const std::vector<Light> lights{light(LightType::sun, "a", false), light(LightType::point, "b"),
                                    light(LightType::spot, "c", false), light(LightType::rect, "d"),
                                    light(LightType::spot, "e")};
    EXPECT_EQ(make_light_set(lights, 16).shadowed, (std::vector<std::uint32_t>{1, 3, 4}));
    const LightSet set = make_light_set(lights, 2);
    EXPECT_EQ(set.shadowed, (std::vector<std::uint32_t>{1, 3}));
    EXPECT_EQ(set.shadow_layer(0), std::nullopt);
    EXPECT_EQ(set.shadow_layer(1), 0u);
    EXPECT_EQ(set.shadow_layer(3), 1u);
    EXPECT_EQ(set.shadow_layer(4), std::nullopt) << "there is no room";
    EXPECT_TRUE(make_light_set(lights, 0).shadowed.empty());
}

TEST(light_set, keys_survive_that_others_come_and_go)
{
    std::vector<Light> lights{light(LightType::sun), light(LightType::point), light(LightType::rect, "window")};
    name_lights(lights); // light0, light1, window
    const std::vector<LightKey> before = make_light_set(lights, 0).keys;
    lights.erase(lights.begin());
    EXPECT_EQ(make_light_set(lights, 0).keys, (std::vector<LightKey>{before[1], before[2]}));
    lights.insert(lights.begin(), light(LightType::spot, "new"));
    const std::vector<LightKey> after = make_light_set(lights, 0).keys;
    EXPECT_EQ(after[1], before[1]);
    EXPECT_EQ(after[2], before[2]);
    EXPECT_EQ(std::count(before.begin(), before.end(), after[0]), 0);
}

TEST(light_set, keys_of_lights_with_an_id_are_their_own_whatever_they_are_called)
{
    std::vector<Light> lights{light(LightType::point, "light0"), light(LightType::point, "light1")};
    lights[0].id = 4;
    lights[1].id = 9;
    const std::vector<LightKey> before = make_light_set(lights, 0).keys;
    lights[1].name = "lamp";
    EXPECT_EQ(make_light_set(lights, 0).keys, before);
    lights[1].name = "light1";
    lights[1].id = 10; // removed, and another made that gets its name
    EXPECT_NE(make_light_set(lights, 0).keys[1], before[1]);
}

TEST(light_set, keys_differ_even_of_lights_without_names_or_with_one)
{
    const std::vector<Light> lights{light(LightType::point), light(LightType::point), light(LightType::point, "light0"),
                                    light(LightType::point, "light0")};
    std::vector<LightKey> keys = make_light_set(lights, 0).keys;
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::unique(keys.begin(), keys.end()), keys.end());
}

TEST(light_set, an_id_is_no_part_of_what_a_light_looks_like)
{
    Light a = light(LightType::spot, "a"), b = a;
    b.id = 3;
    EXPECT_EQ(a, b);
    b.outer += 1;
    EXPECT_NE(a, b);
}

} // namespace
} // namespace atrium
