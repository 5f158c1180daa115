#include "renderer/core/atomic_file.hpp"
#include "renderer/scene/scene_file.hpp"
#include "tests/core/expect_error.hpp"
#include "tests/core/temp_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace atrium {
namespace {

using test::expect_error;
using test::TempFolder;

struct SceneFileTest : ::testing::Test {
    TempFolder folder;

    [[nodiscard]] std::filesystem::path write(const std::string& text) const
    {
        write_text_file(folder / "scene.toml", text);
        return folder / "scene.toml";
    }
    [[nodiscard]] SceneFile read(const std::string& text) const { return read_scene_file(write(text)); }
    /// The text is refused, and the message tells the line.
    template <class... Parts>
    void refuse(const std::string& text, int line, const Parts&... parts) const
    {
        const std::string where = "scene.toml:" + std::to_string(line) + "\n";
        expect_error([&] { (void)read(text); }, ExitCode::input, where, parts...);
    }
};
using scene_file = SceneFileTest;

TEST_F(scene_file, reads_everything)
{
    const SceneFile s = read(R"(bake = "baked/../sponza.atrium"
[settings]
shadow.filter = "pcss"
normal_mapping = false
[settings.ao]
radius = 0.5
samples = 32
ambient.sky = [0.1, 1, 2]
[camera.nave]
eye = [-11.5, 1.7, -0.4]
target = [10, 3.5, -0.4]
fov = 50
[camera.aisle]
eye = [0, 0, 0]
target = [0, 0, 1]
[[light]]
type = "spot"
name = "key"
position = [0.0, 9.0, 0.0]
inner = 10
outer = 25.5
shadow = "off"
color = [1, 0.5, 0]
[[light]]
type = "sun"
shadow = true
[[instance]]
bake = "teapot.atrium"
mesh = "lid"
position = [1, 2, 3]
rotation = [0, 90, 0]
scale = 2
[[instance]]
mesh = "banner"
[[material]]
match = "*fabric*"
class = "cloth"
roughness = 0.5
base_color = [1, 0, 0]
[path.walk]
keys = [{ time = 0.0, eye = [0,0,0], target = [1,0,0] },
        { time = 1.5, eye = [0,1,0], target = [1,0,0] }]
)");
    EXPECT_EQ(s.path, folder / "scene.toml");
    EXPECT_EQ(s.bake, folder / "sponza.atrium");

    const auto setting = [&](std::size_t i) {
        return s.settings.at(i).key + " = " + s.settings.at(i).value + " @" +
               s.settings.at(i).where.substr(s.settings.at(i).where.rfind(':') + 1);
    };
    ASSERT_EQ(s.settings.size(), 5u);
    EXPECT_EQ(setting(0), "shadow.filter = pcss @3");
    EXPECT_EQ(setting(1), "normal_mapping = off @4");
    EXPECT_EQ(setting(2), "ao.radius = 0.5 @6");
    EXPECT_EQ(setting(3), "ao.samples = 32 @7");
    EXPECT_EQ(setting(4), "ao.ambient.sky = 0.1:1:2 @8");
    EXPECT_EQ(s.settings[0].where, (folder / "scene.toml").string() + ":3");

    ASSERT_EQ(s.cameras.size(), 2u); // in file order, not by name
    EXPECT_EQ(s.cameras[0].first, "nave");
    EXPECT_EQ(s.cameras[0].second.eye, vec3(-11.5f, 1.7f, -0.4f));
    EXPECT_EQ(s.cameras[0].second.target, vec3(10, 3.5f, -0.4f));
    EXPECT_EQ(s.cameras[0].second.fov, 50.0f);
    EXPECT_EQ(s.cameras[1].second.fov, 60.0f);

    ASSERT_EQ(s.lights.size(), 2u);
    EXPECT_EQ(s.lights[0], parse_light("spot,name=key,position=0:9:0,inner=10,outer=25.5,shadow=off,color=1:0.5:0"));
    EXPECT_EQ(s.lights[1], parse_light("sun"));

    ASSERT_EQ(s.instances.size(), 2u);
    EXPECT_EQ(s.instances[0].bake, folder / "teapot.atrium");
    EXPECT_EQ(s.instances[0].mesh, "lid");
    EXPECT_EQ(s.instances[0].position, vec3(1, 2, 3));
    EXPECT_EQ(s.instances[0].rotation, vec3(0, 90, 0));
    EXPECT_EQ(s.instances[0].scale, 2.0f);
    EXPECT_EQ(s.instances[1].bake, s.bake);

    ASSERT_EQ(s.materials.size(), 1u);
    Material material;
    apply(s.materials[0], material);
    EXPECT_EQ(material.cls, MaterialClass::cloth);
    EXPECT_EQ(material.roughness, 0.5f);
    EXPECT_EQ(material.base_color, vec3(1, 0, 0));
    EXPECT_EQ(material.metallic, Material{}.metallic);

    ASSERT_EQ(s.paths.at("walk").size(), 2u);
    EXPECT_EQ(s.paths.at("walk")[1].time, 1.5f);
    EXPECT_EQ(s.paths.at("walk")[1].eye, vec3(0, 1, 0));
}

TEST_F(scene_file, unknown_keys_anywhere_tell_line_and_nearest)
{
    refuse("bake = \"a\"\ncamra = 1\n", 2, "unknown key \"camra\"", "did you mean \"camera\"?");
    refuse("bake = \"a\"\n[camera.a]\neye = [0,0,0]\ntarget = [0,0,1]\nfow = 3\n", 5, "camera \"a\"", "\"fov\"?");
    refuse("bake = \"a\"\n[[light]]\ntype = \"sun\"\nilluminence = 3\n", 4, "\"illuminance\"?");
    refuse("bake = \"a\"\n[[light]]\ntpye = \"sun\"\n", 3, "did you mean \"type\"?");
    refuse("bake = \"a\"\n[[light]]\ntype = \"sun\"\nposition = [0,0,0]\n", 4, "unknown key \"position\"");
    refuse("bake = \"a\"\n[[instance]]\nposision = [0,0,0]\n", 3, "\"position\"?");
    refuse("bake = \"a\"\n[[material]]\nmatch = \"*\"\nclas = \"cloth\"\n", 4, "\"class\"?");
    refuse("bake = \"a\"\n[path.walk]\nkey = []\n", 3, "\"keys\"?");
    refuse("bake = \"a\"\n[path.walk]\nkeys = [{ tim = 1 }]\n", 3, "\"time\"?");
}

TEST_F(scene_file, wrong_types_tell_what_was_expected)
{
    const std::string camera = "bake = \"a\"\n[camera.a]\ntarget = [0,0,1]\n";
    refuse("bake = 3\n", 1, "expected a string, found a whole number");
    refuse("bake = \"\"\n", 1, "it is empty");
    refuse("bake = \"a\"\nsettings = 3\n", 2, "expected a table, found a whole number");
    refuse("bake = \"a\"\n[camera]\na = 3\n", 3, "expected a table", "[camera.NAME]");
    refuse("bake = \"a\"\n[light]\ntype = \"sun\"\n", 2, "expected an array of tables, found a table");
    refuse("bake = \"a\"\nlight = [1]\n", 2, "expected an array of tables");
    refuse(camera + "eye = [0,0]\n", 4, "expected an array of three numbers");
    refuse(camera + "eye = [0,0,\"1\"]\n", 4, "three finite numbers");
    refuse(camera + "eye = [0,0,nan]\n", 4, "three finite numbers");
    refuse(camera + "eye = \"0:0:0\"\n", 4, "found a string");
    refuse(camera + "eye = [0,0,1e7]\n", 4, "the range");
    refuse(camera + "eye = [0,0,0]\nfov = \"60\"\n", 5, "expected a finite number, found a string");
    refuse(camera + "eye = [0,0,0]\nfov = inf\n", 5, "expected a finite number");
    refuse("bake = \"a\"\n[[light]]\ntype = \"sun\"\nangle = \"1\"\n", 4, "expected a finite number");
    refuse("bake = \"a\"\n[[light]]\ntype = \"sun\"\nshadow = 1\n", 4, "\"on\" or \"off\"");
    refuse("bake = \"a\"\n[settings]\nao.radius = [1, 2]\n", 3, "ao.radius", "found an array");
    refuse("bake = \"a\"\n[settings]\nao.radius = 2020-01-01\n", 3, "a date");
}

TEST_F(scene_file, values_are_held_to_the_rules_of_the_command_line)
{
    const std::string camera = "bake = \"a\"\n[camera.a]\neye = [0,0,0]\n";
    refuse("[settings]\n", 1, "has no \"bake\"");
    refuse(camera, 2, "camera \"a\" has no \"target\"");
    refuse(camera + "target = [0,0,0]\n", 4, "same point");
    refuse(camera + "target = [0,0,1]\nfov = 170\n", 5, "between 1 and 170");
    const std::string light = "bake = \"a\"\n[[light]]\n";
    refuse(light, 2, "has no \"type\"");
    refuse(light + "type = \"spo\"\n", 3, "did you mean \"spot\"?");
    refuse(light + "type = \"spot\"\n", 3, "has no \"position\"");
    refuse(light + "type = \"sun\"\nangle = 91\n", 4, "0 to 90 degrees");
    refuse(light + "type = \"sun\"\nname = \"7\"\n", 3, "bad light name");
    refuse("bake = \"a\"\n[[material]]\nclass = \"cloth\"\n", 2, "has no \"match\"");
    refuse("bake = \"a\"\n[[material]]\nmatch = \"*\"\nclass = \"silk\"\n", 4, "opaque, masked, blended, cloth");
    refuse("bake = \"a\"\n[[material]]\nmatch = \"*\"\nroughness = 2\n", 4, "the range is 0 to 1");
    refuse("bake = \"a\"\n[[instance]]\nscale = 0\n", 3, "the range");
    refuse("bake = \"a\"\n[path.p]\nkeys = []\n", 3, "has no keys");
    refuse("bake = \"a\"\n[path.p]\nkeys = [{time=1,eye=[0,0,0],target=[0,0,1]},\n{time=1,eye=[0,0,0],target=[0,0,1]}]",
           4, "not later");
}

TEST_F(scene_file, bad_toml_tells_the_line)
{
    refuse("bake = \"a\"\n\nbake = \"b\"\n", 3, "not valid TOML");
    refuse("bake = \"a\"\n[settings\n", 2, "not valid TOML");
    refuse("bake = \"\xff\"\n", 1, "not valid TOML");
    expect_error([&] { (void)read_scene_file(folder / "none.toml"); }, ExitCode::input, "none.toml", "No such file");
}

TEST_F(scene_file, hostile_files_are_refused_at_once)
{
    std::string dots = "a", quoted = "'='", deep_array = "x = ";
    for (int i = 0; i < 1'000'000; ++i) dots += ".a";
    for (int i = 0; i < 500'000; ++i) quoted += ".\"]\"";
    deep_array += std::string(1'000'000, '[');
    refuse("\n" + dots + " = 1", 2, "too many parts");
    refuse("x = \"\"\"a\n\"\"\"\"\" # '\n" + quoted + " = 1", 3, "too many parts");
    expect_error([&] { (void)read(deep_array); }, ExitCode::input);
    expect_error([&] { (void)read(std::string(5 << 20, '\n')); }, ExitCode::input, "too large");
    // As deep as it goes: tables in arrays in tables, each under a key of as many parts as are allowed.
    std::string nested;
    for (int i = 0; i < 200; ++i) nested += "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = [ {";
    expect_error([&] { (void)read(nested); }, ExitCode::input);
}

TEST_F(scene_file, long_lines_of_numbers_and_dots_in_texts_are_no_endless_keys)
{
    std::string text = "# ................................................\nbake = \"" + std::string(60, '.') +
                       "\"\n[path.p]\nkeys = [";
    for (int i = 0; i < 100; ++i) {
        text += "{ time = " + std::to_string(i) + ".5, eye = [0.0,0.0,0.0], target = [1.0,1.0,1.0] },";
    }
    EXPECT_EQ(read(text + "]\n").paths.at("p").size(), 100u);
}

TEST_F(scene_file, settings_file_with_or_without_the_table)
{
    const auto keys = [&](const std::string& text) {
        std::string out;
        for (const SettingText& s : read_settings_file(write(text)).settings) out += s.key + "=" + s.value + " ";
        return out;
    };
    EXPECT_EQ(keys("[settings]\nao.radius = 1.0\ntonemap.operator = \"agx\"\n"), "ao.radius=1 tonemap.operator=agx ");
    EXPECT_EQ(keys("normal_mapping = true\n[ao]\nradius = 0.1\n"), "normal_mapping=on ao.radius=0.1 ");
    EXPECT_EQ(keys(""), "");
    expect_error([&] { (void)keys("ao.radius = {}\nx = [1]"); }, ExitCode::input, "scene.toml:2");
}

TEST(matches_pattern, stars_and_question_marks)
{
    EXPECT_TRUE(matches_pattern("*fabric*", "red_fabric_01"));
    EXPECT_TRUE(matches_pattern("*", ""));
    EXPECT_TRUE(matches_pattern("a?c", "abc"));
    EXPECT_TRUE(matches_pattern("*ab", "aab"));
    EXPECT_TRUE(matches_pattern("a*b*c", "a_b_b_c"));
    EXPECT_FALSE(matches_pattern("a?c", "ac"));
    EXPECT_FALSE(matches_pattern("fabric", "red_fabric"));
    EXPECT_FALSE(matches_pattern("", "a"));
    EXPECT_FALSE(matches_pattern("a*b*c", "a_c_b"));
    EXPECT_FALSE(matches_pattern(std::string(200, '*') + "b", std::string(10'000, 'a'))); // at once
}

} // namespace
} // namespace atrium
