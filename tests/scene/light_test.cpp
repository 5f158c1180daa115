#include "renderer/scene/light.hpp"
#include "tests/core/expect_error.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace atrium {
namespace {

using test::expect_error;

TEST(light, defaults_of_every_type)
{
    const Light sun = parse_light("sun");
    EXPECT_EQ(sun.type, LightType::sun);
    EXPECT_EQ(sun.direction, vec3(-0.3f, -1, -0.2f));
    EXPECT_EQ(sun.illuminance, 10.0f);
    EXPECT_EQ(sun.angle, 0.53f);
    EXPECT_EQ(sun.color, vec3(1));
    EXPECT_TRUE(sun.shadow);
    EXPECT_EQ(sun.name, "");

    const Light spot = parse_light("spot,position=1:2:3");
    EXPECT_EQ(spot.position, vec3(1, 2, 3));
    EXPECT_EQ(spot.direction, vec3(0, -1, 0));
    EXPECT_EQ(spot.intensity, 100.0f);
    EXPECT_EQ(spot.inner, 20.0f);
    EXPECT_EQ(spot.outer, 30.0f);
    EXPECT_EQ(spot.size, 0.05f);
    EXPECT_EQ(spot.range, 0.0f);

    const Light rect = parse_light("rect,position=0:0:0");
    EXPECT_EQ(rect.direction, vec3(0, -1, 0));
    EXPECT_EQ(rect.up, vec3(0, 1, 0));
    EXPECT_EQ(rect.width, 1.0f);
    EXPECT_EQ(rect.height, 1.0f);
    EXPECT_EQ(rect.radiance, 10.0f);
    EXPECT_EQ(parse_light("point,position=0:0:0").type, LightType::point);
}

TEST(light, every_key_is_read_and_written_back)
{
    for (const std::string spec : {
             "sun",
             "sun,name=day,color=1:0.9:0.8,shadow=off,direction=0:-1:0,illuminance=3.5,angle=2",
             "spot,position=0:9:0",
             "spot,position=-1:2.5:1e-05,name=key,color=0:0:1,shadow=off,direction=1:0:0,inner=0,outer=80",
             "spot,position=0:0:0,intensity=0,size=0.5,range=12",
             "point,position=1:2:3,intensity=7,size=0.1,range=4",
             "rect,position=0:3:0,direction=0:0:1,up=1:0:0,width=2,height=0.5,radiance=20",
         }) {
        const Light light = parse_light(spec);
        EXPECT_EQ(to_spec(light), spec);
        EXPECT_EQ(parse_light(to_spec(light)), light);
    }
    // In any order, and values that are the defaults are left out.
    EXPECT_EQ(to_spec(parse_light("spot,shadow=true,outer=30,position=0:0:0")), "spot,position=0:0:0");
}

TEST(light, bad_specs_name_key_range_and_nearest)
{
    const auto refuse = [](const char* spec, auto... parts) {
        expect_error([&] { (void)parse_light(spec); }, ExitCode::usage, spec, parts...);
    };
    refuse("", "unknown light type", "sun, spot, point, rect");
    refuse("pont,position=0:0:0", "unknown light type \"pont\"", "did you mean \"point\"?");
    refuse("spot,positon=0:0:0", "unknown spot light key \"positon\"", "did you mean \"position\"?");
    refuse("point,position=0:0:0,direction=0:1:0", "unknown point light key \"direction\"");
    refuse("sun,position=0:0:0", "unknown sun light key \"position\"");
    refuse("spot", "has no \"position\"");
    refuse("point,intensity=1", "has no \"position\"");
    refuse("rect", "has no \"position\"");
    refuse("sun,", "no equals sign");
    refuse("sun,illuminance", "no equals sign", "\"illuminance=");
    refuse("sun,angle=1,angle=1", "\"angle\" is given twice");
    refuse("sun,illuminance=bright", "bad value \"bright\"", "a number");
    refuse("sun,illuminance=-1", "the range is 0 to 1000000000 lx");
    refuse("sun,illuminance=nan", "a number");
    refuse("sun,illuminance=inf", "a number");
    refuse("sun,direction=1:2", "x:y:z");
    refuse("sun,direction=0:0:0", "direction", "points nowhere");
    refuse("sun,color=1:-1:1", "color", "the range is");
    refuse("sun,shadow=maybe", "on, off, true or false");
    refuse("spot,position=0:0:0,outer=81", "outer", "0.1 to 80 degrees");
    refuse("spot,position=0:0:0,inner=31", "inner angle 31 is larger than its outer angle 30");
    refuse("spot,position=0:0:0,size=0", "size", "the range is");
    refuse("spot,position=0:0:0,range=-1", "range", "the range is");
    refuse("spot,position=2000000:0:0", "position", "the range is");
    refuse("rect,position=0:0:0,width=0", "width", "the range is");
    refuse("rect,position=0:0:0,height=-1", "height", "the range is");
    refuse("rect,position=0:0:0,up=0:0:0", "up", "points nowhere");
    refuse("sun,name=12", "bad light name \"12\"", "index");
    refuse("sun,name=a=b", "bad light name");
}

TEST(light, a_spots_angles_may_come_in_any_order)
{
    EXPECT_EQ(parse_light("spot,position=0:0:0,inner=40,outer=50").inner, 40.0f);
    EXPECT_EQ(parse_light("spot,position=0:0:0,outer=50,inner=50").outer, 50.0f);
}

std::vector<Light> named(std::vector<std::string> names)
{
    std::vector<Light> lights;
    for (std::string& name : names) {
        lights.push_back(default_light(LightType::sun));
        lights.back().name = std::move(name);
    }
    return lights;
}

TEST(light, default_names_are_by_index)
{
    std::vector<Light> lights = named({"", "key", "", "light7"});
    name_lights(lights);
    EXPECT_EQ(lights[0].name, "light0");
    EXPECT_EQ(lights[1].name, "key");
    EXPECT_EQ(lights[2].name, "light2");
    EXPECT_EQ(lights[3].name, "light7");
    EXPECT_EQ(parse_light(to_spec(lights[2])), lights[2]);
}

TEST(light, names_of_digits_and_names_used_twice_are_errors_of_the_given_code)
{
    const auto refuse = [](std::vector<std::string> names, ExitCode code, auto... parts) {
        std::vector<Light> lights = named(std::move(names));
        expect_error([&] { name_lights(lights, code); }, code, parts...);
    };
    refuse({"a", "42"}, ExitCode::usage, "\"42\"", "light 1");
    refuse({"a", "b", "a"}, ExitCode::input, "\"a\" is used twice", "lights 0 and 2");
    refuse({"light1", ""}, ExitCode::input, "\"light1\" is used twice");
    refuse(std::vector<std::string>(65), ExitCode::usage, "too many lights: 65", "64");
    std::vector<Light> most(64, default_light(LightType::sun));
    EXPECT_NO_THROW(name_lights(most));
}

TEST(light, find_by_name_or_index)
{
    std::vector<Light> lights = named({"key", "", "fill"});
    name_lights(lights);
    EXPECT_EQ(find_light(lights, "fill"), 2u);
    EXPECT_EQ(find_light(lights, "light1"), 1u);
    EXPECT_EQ(find_light(lights, "0"), 0u);
    expect_error([&] { (void)find_light(lights, "fil"); }, ExitCode::usage, "unknown light \"fil\"",
                 "did you mean \"fill\"?", "key, light1, fill");
    expect_error([&] { (void)find_light(lights, "3"); }, ExitCode::usage, "unknown light \"3\"");
    expect_error([&] { (void)find_light(lights, "99999999999999999999"); }, ExitCode::usage);
    expect_error([&] { (void)find_light(lights, "-1"); }, ExitCode::usage);
    expect_error([&] { (void)find_light(lights, ""); }, ExitCode::usage);
    expect_error([] { (void)find_light({}, "key"); }, ExitCode::usage, "no light", "--light");
}

void expect_orthonormal(const LightAxes& a)
{
    EXPECT_NEAR(glm::length(a.direction), 1, 1e-6f);
    EXPECT_NEAR(glm::length(a.right), 1, 1e-6f);
    EXPECT_NEAR(glm::dot(a.direction, a.up), 0, 1e-6f);
    EXPECT_NEAR(glm::distance(glm::cross(a.direction, a.up), a.right), 0, 1e-6f);
}

TEST(light, axes_take_x_as_up_where_y_is_parallel)
{
    Light light = default_light(LightType::rect);
    EXPECT_EQ(axes_of(light).direction, vec3(0, -1, 0));
    EXPECT_EQ(axes_of(light).up, vec3(1, 0, 0));
    expect_orthonormal(axes_of(light));
    light.direction = {0, 0, 5};
    EXPECT_EQ(axes_of(light).up, vec3(0, 1, 0));
    light.up = {1, 1, 1};
    expect_orthonormal(axes_of(light));
    light.direction = light.up = {-2, 0, 0}; // both fall together with +X
    EXPECT_EQ(axes_of(light).up, vec3(0, 1, 0));
}

} // namespace
} // namespace atrium
