#include "renderer/core/setting.hpp"
#include "tests/core/expect_error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <stdexcept>

namespace atrium {
namespace {

using test::error_of;
using test::expect_error;

enum class Method { off, ssao, gtao };
constexpr auto enum_names(Method)
{
    return std::array{"off", "ssao", "gtao"};
}

struct SomeSettings {
    bool normal_mapping = true;
    Method method = Method::gtao;
    float radius = 0.6f;
    int samples = 18;
    vec3 sky{0.5f, 0.6f, 1.0f};
    std::string view = "hdr";
};

template <class V>
void describe(V& v, SomeSettings& s)
{
    v.group("", "General");
    v("normal_mapping", s.normal_mapping, "Use normal maps");
    v.group("ao", "Ambient occlusion");
    v("method", s.method, "Which method, or off", Cpu{Method::ssao});
    v("radius", s.radius, "How far occluders are sought", Range{0.05f, 50.0f}, "m");
    v("samples", s.samples, "Depth samples", Range{4, 512}, "per pixel", Cpu{8});
    v.group("ambient", "Ambient light");
    v("sky", s.sky, "Light from above | linear", Range{0, 100});
    v("view", s.view, "An AOV's name");
}

struct Fixture : ::testing::Test {
    SomeSettings s;
    SettingList list;
    Fixture() { describe(list, s); }

    void set(const char* key, const char* text) const { list.set(key, text, ExitCode::usage, "--set"); }
};
using setting_list = Fixture;

TEST_F(setting_list, lists_every_field_in_order_with_its_description)
{
    ASSERT_EQ(list.all().size(), 6u);
    EXPECT_EQ(list.all()[0].key, "normal_mapping");
    EXPECT_STREQ(list.all()[0].type(), "bool");
    EXPECT_EQ(list.all()[1].key, "ao.method");
    EXPECT_STREQ(list.all()[1].type(), "enum");
    EXPECT_EQ(list.all()[1].values, (std::vector<std::string>{"off", "ssao", "gtao"}));
    EXPECT_EQ(list.all()[1].group_title, "Ambient occlusion");
    const Setting* samples = list.find("ao.samples");
    ASSERT_NE(samples, nullptr);
    EXPECT_STREQ(samples->type(), "int");
    EXPECT_EQ(samples->unit, "per pixel");
    EXPECT_EQ(samples->default_text, "18");
    EXPECT_EQ(samples->cpu_default, "8");
    EXPECT_EQ(list.find("ao.radius")->cpu_default, "0.6");
    EXPECT_STREQ(list.find("ambient.sky")->type(), "vec3");
    EXPECT_STREQ(list.find("ambient.view")->type(), "string");
    EXPECT_EQ(list.find("ao"), nullptr);
}

TEST_F(setting_list, sets_the_live_struct)
{
    set("normal_mapping", "off");
    set("ao.method", "ssao");
    set("ao.radius", "50");
    set("ao.samples", "4");
    set("ambient.sky", "0:0.25:100");
    set("ambient.view", "ao_raw");
    EXPECT_FALSE(s.normal_mapping);
    EXPECT_EQ(s.method, Method::ssao);
    EXPECT_EQ(s.radius, 50.0f);
    EXPECT_EQ(s.samples, 4);
    EXPECT_EQ(s.sky, vec3(0, 0.25f, 100));
    EXPECT_EQ(s.view, "ao_raw");
    set("normal_mapping", "true");
    EXPECT_TRUE(s.normal_mapping);
}

TEST_F(setting_list, get_and_set_round_trip)
{
    s.radius = 1.0f / 3.0f;
    for (const Setting& setting : list.all()) {
        const std::string text = setting.get();
        EXPECT_FALSE(setting.set_text(text).has_value()) << setting.key;
        EXPECT_EQ(setting.get(), text);
    }
    EXPECT_EQ(s.radius, 1.0f / 3.0f);
}

TEST_F(setting_list, an_unknown_key_names_the_nearest)
{
    expect_error([&] { set("ao.raduis", "1"); }, ExitCode::usage, "unknown setting \"ao.raduis\"", "where: --set",
                 "did you mean \"ao.radius\"?", "atrium settings");
    expect_error([&] { list.set("ao", "1", ExitCode::input, "f.toml:3"); }, ExitCode::input, "f.toml:3");
}

TEST_F(setting_list, bad_values_are_refused_and_change_nothing)
{
    expect_error([&] { set("ao.radius", "wide"); }, ExitCode::usage, "bad value \"wide\"", "ao.radius", "a number",
                 "0.05 to 50 m");
    expect_error([&] { set("ao.radius", "nan"); }, ExitCode::usage, "a number");
    expect_error([&] { set("ao.radius", "1 "); }, ExitCode::usage, "a number");
    expect_error([&] { set("ao.radius", "0.04"); }, ExitCode::usage, "the range is 0.05 to 50 m");
    expect_error([&] { set("ao.radius", "50.001"); }, ExitCode::usage, "the range is");
    expect_error([&] { set("ao.samples", "18.5"); }, ExitCode::usage, "a whole number");
    expect_error([&] { set("ao.samples", "513"); }, ExitCode::usage, "4 to 512 per pixel");
    expect_error([&] { set("ambient.sky", "1:1"); }, ExitCode::usage, "x:y:z");
    expect_error([&] { set("ambient.sky", "1:-1:1"); }, ExitCode::usage, "the range is 0 to 100");
    expect_error([&] { set("normal_mapping", "yes"); }, ExitCode::usage, "on, off, true or false");
    expect_error([&] { set("ao.method", "gato"); }, ExitCode::usage, "off, ssao, gtao", "did you mean \"gtao\"?");
    EXPECT_TRUE(list.differing().empty());
}

TEST_F(setting_list, cpu_defaults_and_what_differs)
{
    EXPECT_TRUE(list.differing().empty());
    list.apply_cpu_defaults();
    EXPECT_EQ(s.method, Method::ssao);
    EXPECT_EQ(s.samples, 8);
    EXPECT_EQ(s.radius, 0.6f);
    const std::vector<std::pair<std::string, std::string>> expected{{"ao.method", "ssao"}, {"ao.samples", "8"}};
    EXPECT_EQ(list.differing(), expected);
}

TEST_F(setting_list, structs_are_compared_field_by_field)
{
    SomeSettings other;
    EXPECT_TRUE(same_settings(s, other));
    const std::vector<std::pair<const char*, const char*>> changes{
        {"normal_mapping", "off"}, {"ao.method", "ssao"},          {"ao.radius", "0.6000001"},
        {"ao.samples", "19"},      {"ambient.sky", "0.5:0.6:1.5"}, {"ambient.view", "hdr "}};
    ASSERT_EQ(changes.size(), list.all().size());
    for (const auto& [key, text] : changes) {
        EXPECT_TRUE(list.find(key)->is_default(false)) << key;
        set(key, text);
        EXPECT_FALSE(same_settings(s, other)) << key;
        EXPECT_FALSE(same_settings(other, s)) << key;
        EXPECT_FALSE(list.find(key)->is_default(false)) << key;
        EXPECT_EQ(list.differing().size(), 1u) << key;
        s = other;
        EXPECT_TRUE(same_settings(s, other)) << key;
    }
    set("ao.samples", "8");
    EXPECT_TRUE(list.find("ao.samples")->is_default(true));
}

TEST_F(setting_list, toml_holds_everything)
{
    EXPECT_EQ(list.to_toml(), R"([settings]

# ---- General
# Use normal maps; on, off
normal_mapping = true

# ---- Ambient occlusion
# Which method, or off; off, ssao, gtao; on a CPU device "ssao"
ao.method = "gtao"
# How far occluders are sought; 0.05 to 50 (m)
ao.radius = 0.6
# Depth samples; 4 to 512 (per pixel); on a CPU device 8
ao.samples = 18

# ---- Ambient light
# Light from above | linear; 0 to 100
ambient.sky = [0.5,0.6,1.0]
# An AOV's name
ambient.view = "hdr"
)");
    s.view = "a\"b\\c\n";
    EXPECT_NE(list.to_toml().find(R"(ambient.view = "a\"b\\c\n")"), std::string::npos);
}

TEST_F(setting_list, json_is_typed)
{
    s.radius = 2; // the present value does not show in it
    const auto json = nlohmann::json::parse(list.to_json());
    ASSERT_EQ(json.size(), 6u);
    EXPECT_EQ(json[0], nlohmann::json::parse(R"({"key":"normal_mapping","type":"bool","unit":"","range":null,
        "values":null,"default":true,"cpu_default":true,"help":"Use normal maps"})"));
    EXPECT_EQ(json[1], nlohmann::json::parse(R"({"key":"ao.method","type":"enum","unit":"","range":null,
        "values":["off","ssao","gtao"],"default":"gtao","cpu_default":"ssao","help":"Which method, or off"})"));
    EXPECT_EQ(json[2], nlohmann::json::parse(R"({"key":"ao.radius","type":"float","unit":"m","range":[0.05,50.0],
        "values":null,"default":0.6,"cpu_default":0.6,"help":"How far occluders are sought"})"));
    EXPECT_EQ(json[3], nlohmann::json::parse(R"({"key":"ao.samples","type":"int","unit":"per pixel","range":[4,512],
        "values":null,"default":18,"cpu_default":8,"help":"Depth samples"})"));
    EXPECT_EQ(json[4]["default"], nlohmann::json::parse("[0.5,0.6,1.0]"));
}

TEST_F(setting_list, markdown_has_a_table_per_group)
{
    const std::string text = list.to_markdown();
    EXPECT_NE(text.find("## Ambient occlusion\n\n| key |"), std::string::npos);
    EXPECT_NE(text.find("| `ao.samples` | int | `18` | `8` | 4 to 512 | per pixel | Depth samples |  |\n"),
              std::string::npos);
    EXPECT_NE(text.find("Light from above \\| linear"), std::string::npos);
}

struct Broken {
    float a = 1, b = 2;
};

TEST(setting_defects, colliding_keys_and_bad_defaults_are_logic_errors)
{
    Broken broken;
    SettingList list;
    list.group("x", "X");
    list("a", broken.a, "");
    EXPECT_THROW(list("a", broken.b, ""), std::logic_error);
    EXPECT_THROW(list("a.b", broken.b, ""), std::logic_error); // x.a would be a value and a table in TOML
    EXPECT_THROW(list("b", broken.b, "", Range{5, 6}), std::logic_error);
    EXPECT_THROW(list("c", broken.b, "", Range{0, 3}, Cpu{4.0f}), std::logic_error);
    EXPECT_EQ(broken.b, 2.0f);
}

TEST(setting_defects, another_noun_words_the_messages)
{
    Broken broken;
    SettingList list("spot light key", "");
    list.group("", "");
    list("a", broken.a, "");
    const auto error = error_of([&] { list.set("aa", "1", ExitCode::usage, "--light"); });
    ASSERT_TRUE(error.has_value());
    EXPECT_STREQ(error->what(), "unknown spot light key \"aa\"");
    EXPECT_EQ(error->next(), "did you mean \"a\"?");
}

} // namespace
} // namespace atrium
