#include "app/gui/view_model.hpp"

#include "renderer/core/text_value.hpp"
#include "tests/core/expect_error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace atrium::gui {
namespace {

std::vector<Light> two_lights()
{
    Light sun = default_light(LightType::sun), point = default_light(LightType::point);
    sun.name = "sun";
    point.position = {0.1f, 1.0f / 3.0f, 3};
    point.color = {1, 0.9f, 0.8f};
    return {sun, point};
}

struct Fixture : ::testing::Test {
    ViewModel model;
    Fixture()
    {
        Settings settings;
        settings.ao.radius = 1.0f / 3.0f;
        model.reset(settings, Camera{}, two_lights());
    }
};
using view_model = Fixture;

TEST_F(view_model, begins_with_what_it_is_given_and_nothing_to_undo)
{
    EXPECT_EQ(model.settings.ao.radius, 1.0f / 3.0f);
    EXPECT_EQ(model.list.find("ao.radius")->default_text, "0.5");
    EXPECT_EQ(model.lights[1].name, "light1");
    EXPECT_FALSE(model.selected.has_value());
    EXPECT_FALSE(model.can_undo());
    EXPECT_FALSE(model.can_redo());
    model.checkpoint();
    EXPECT_FALSE(model.can_undo());
    model.undo();
    model.redo();
    EXPECT_EQ(model.settings.ao.radius, 1.0f / 3.0f);
}

TEST_F(view_model, undo_and_redo_restore_settings_and_lights_exactly)
{
    const auto texts = [&] { return model.list.differing(); };
    const auto texts0 = texts();
    const std::vector<Light> lights0 = model.lights;

    model.settings.ao.radius = 0.1f + 0.2f;
    model.settings.sky.zenith = {0.1f, 1e-7f, 3e5f};
    model.settings.debug.view = "ao \"raw\"";
    model.settings.shadow.cache = !model.settings.shadow.cache;
    model.checkpoint();
    const auto texts1 = texts();

    model.lights[1].intensity = 0.1f + 0.7f;
    model.lights.erase(model.lights.begin());
    model.checkpoint();
    const std::vector<Light> lights2 = model.lights;

    model.undo();
    EXPECT_EQ(model.lights, lights0);
    EXPECT_EQ(texts(), texts1);
    EXPECT_EQ(model.settings.ao.radius, 0.1f + 0.2f);
    model.undo();
    EXPECT_EQ(texts(), texts0);
    EXPECT_EQ(model.settings.ao.radius, 1.0f / 3.0f);
    EXPECT_EQ(model.settings.debug.view, "");
    EXPECT_FALSE(model.can_undo());
    model.redo();
    EXPECT_EQ(texts(), texts1);
    EXPECT_EQ(model.settings.sky.zenith, vec3(0.1f, 1e-7f, 3e5f));
    model.redo();
    EXPECT_EQ(model.lights, lights2);
    EXPECT_FALSE(model.can_redo());
}

TEST_F(view_model, an_edit_without_its_checkpoint_is_a_step_too)
{
    model.settings.ao.samples = 4;
    EXPECT_TRUE(model.can_undo());
    model.undo();
    EXPECT_EQ(model.settings.ao.samples, Settings{}.ao.samples);
    EXPECT_TRUE(model.can_redo());
    model.redo();
    EXPECT_EQ(model.settings.ao.samples, 4);
}

/// Another value that the setting takes.
std::string another_value(const Setting& s)
{
    const std::string type = s.type();
    if (type == "bool") return s.get() == "on" ? "off" : "on";
    if (type == "enum") return s.values.size() > 1 ? s.values[s.get() == s.values[0] ? 1 : 0] : "";
    if (type == "vec3") return "0.125:0.25:0.375";
    if (type == "string") return "depth";
    if (!s.range) return "0.125";
    const auto text = [&](float v) { return type == "int" ? fmt::format("{}", static_cast<int>(v)) : to_text(v); };
    return s.get() == text(s.range->max) ? text(s.range->min) : text(s.range->max);
}

TEST_F(view_model, an_edit_of_any_setting_is_a_step)
{
    std::size_t edited = 0;
    for (const Setting& s : model.list.all()) {
        const std::string before = s.get(), after = another_value(s);
        if (after.empty()) {
            EXPECT_EQ(s.values.size(), 1u) << s.key;
            continue;
        }
        ASSERT_FALSE(s.set_text(after).has_value()) << s.key << " = " << after;
        ASSERT_TRUE(model.can_undo()) << s.key;
        model.checkpoint();
        ASSERT_TRUE(model.can_undo()) << s.key;
        model.undo();
        EXPECT_EQ(s.get(), before) << s.key;
        EXPECT_FALSE(model.can_undo()) << s.key;
        ++edited;
    }
    EXPECT_GT(edited, 40u);
}

TEST_F(view_model, an_edit_of_a_material_is_a_step)
{
    model.materials = {{"brick", {{"roughness", "0.5"}}}};
    EXPECT_TRUE(model.can_undo());
    model.checkpoint();
    model.materials[0].values[0].second = "0.6";
    EXPECT_TRUE(model.can_undo());
    model.undo();
    ASSERT_EQ(model.materials.size(), 1u);
    EXPECT_EQ(model.materials[0].values[0].second, "0.5");
}

TEST_F(view_model, a_new_edit_forgets_what_was_undone)
{
    model.settings.ao.samples = 4;
    model.checkpoint();
    model.undo();
    model.settings.ao.power = 2;
    EXPECT_FALSE(model.can_redo());
    model.checkpoint();
    model.redo();
    EXPECT_EQ(model.settings.ao.samples, Settings{}.ao.samples);
    EXPECT_EQ(model.settings.ao.power, 2.0f);
}

TEST_F(view_model, undo_leaves_the_camera_and_a_selection_that_is_still_there)
{
    model.camera.eye = {9, 9, 9};
    model.selected = 1;
    model.settings.ao.samples = 4;
    model.undo();
    EXPECT_EQ(model.camera.eye, vec3(9));
    EXPECT_EQ(model.selected, 1u);
    ASSERT_TRUE(model.add_light(LightType::rect, vec3(0)));
    EXPECT_EQ(model.selected, 2u);
    model.undo();
    EXPECT_EQ(model.lights.size(), 2u);
    EXPECT_FALSE(model.selected.has_value());
}

TEST_F(view_model, texts_are_applied_all_or_none)
{
    const std::vector<SettingText> good{{"ao.radius", "2", "f:1"}, {"ao.method", "gtao", "f:2"}};
    EXPECT_EQ(model.apply_texts(good), std::nullopt);
    EXPECT_EQ(model.settings.ao.radius, 2.0f);
    EXPECT_EQ(model.settings.ao.method, AoMethod::gtao);

    const std::vector<SettingText> bad{{"ao.radius", "3", "f:1"}, {"ao.samples", "many", "f:2"}};
    const auto error = model.apply_texts(bad);
    ASSERT_TRUE(error.has_value());
    EXPECT_NE(error->find("ao.samples"), std::string::npos);
    EXPECT_NE(error->find("f:2"), std::string::npos);
    EXPECT_EQ(model.settings.ao.radius, 2.0f);
    model.undo();
    EXPECT_EQ(model.settings.ao.radius, 1.0f / 3.0f);
}

TEST_F(view_model, what_it_saves_it_reads_back)
{
    model.settings.debug.view = "a\"b\\c";
    model.settings.sky.zenith = {0.1f, 0.2f, 0.3f};
    const std::string toml = model.settings_toml();
    ViewModel other;
    EXPECT_EQ(other.settings_toml(), "[settings]\n");
    EXPECT_EQ(other.apply_texts(parse_settings(toml, "saved")), std::nullopt);
    EXPECT_EQ(other.list.differing(), model.list.differing());
    EXPECT_EQ(other.settings_toml(), toml);
}

TEST_F(view_model, defaults_are_the_device_s)
{
    model.apply_defaults(true);
    for (const Setting& s : model.list.all()) EXPECT_EQ(s.get(), s.cpu_default) << s.key;
    model.apply_defaults(false);
    EXPECT_TRUE(model.list.differing().empty());
}

TEST_F(view_model, lights_are_added_copied_and_removed)
{
    ASSERT_TRUE(model.add_light(LightType::spot, {1, 2, 3}));
    EXPECT_EQ(model.lights[2].type, LightType::spot);
    EXPECT_EQ(model.lights[2].position, vec3(1, 2, 3));
    EXPECT_EQ(model.lights[2].name, "light2");
    model.lights[2].intensity = 7;
    ASSERT_TRUE(model.duplicate_selected());
    EXPECT_EQ(model.lights[3].intensity, 7.0f);
    EXPECT_EQ(model.lights[3].name, "light3");
    EXPECT_EQ(model.selected, 3u);
    model.selected = 0;
    model.remove_selected();
    EXPECT_EQ(model.lights.size(), 3u);
    EXPECT_EQ(model.selected, 0u);
    ASSERT_TRUE(model.add_light(LightType::sun, {1, 2, 3}));
    EXPECT_EQ(model.lights[3].name, "light4"); // light3 is taken
    EXPECT_EQ(model.lights[3].position, vec3(0));
    for (const Light& light : model.lights) EXPECT_NO_THROW(check_light(light, ExitCode::usage, ""));
    while (model.selected) model.remove_selected();
    EXPECT_TRUE(model.lights.empty());
    EXPECT_FALSE(model.duplicate_selected());
}

TEST_F(view_model, each_light_stays_itself_whatever_happens_to_the_others)
{
    const auto ids = [&] {
        std::vector<std::uint32_t> out;
        for (const Light& light : model.lights) out.push_back(light.id);
        return out;
    };
    ASSERT_TRUE(model.add_light(LightType::spot, {1, 2, 3}));
    const std::vector<std::uint32_t> three = ids();
    EXPECT_EQ(std::set(three.begin(), three.end()).size(), 3u);
    EXPECT_EQ(std::count(three.begin(), three.end(), 0u), 0);
    model.checkpoint();
    model.selected = 1;
    model.remove_selected();
    EXPECT_EQ(ids(), (std::vector{three[0], three[2]}));
    model.undo();
    EXPECT_EQ(ids(), three) << "it is the same one again";
    model.selected = 2;
    model.remove_selected();
    ASSERT_TRUE(model.add_light(LightType::spot, {1, 2, 3}));
    EXPECT_EQ(model.lights[2].name, "light2");
    EXPECT_EQ(std::count(three.begin(), three.end(), ids()[2]), 0) << "it has the name of a light that went, no more";
    ASSERT_TRUE(model.duplicate_selected());
    EXPECT_NE(ids()[3], ids()[2]);
    Light renamed = default_light(LightType::point);
    renamed.name = "lamp";
    const std::uint32_t before = ids()[0];
    EXPECT_EQ(model.set_light(0, renamed), std::nullopt);
    EXPECT_EQ(ids()[0], before);
    model.reset(model.settings, model.camera, {default_light(LightType::sun)});
    EXPECT_EQ(std::count(three.begin(), three.end(), ids()[0]), 0) << "another scene has other lights";
}

TEST_F(view_model, there_are_no_more_lights_than_can_be_drawn)
{
    while (model.add_light(LightType::point, vec3(0))) {
    }
    EXPECT_EQ(model.lights.size(), static_cast<std::size_t>(max_lights));
    EXPECT_FALSE(model.duplicate_selected());
    EXPECT_NO_THROW(name_lights(model.lights));
}

TEST_F(view_model, a_light_that_breaks_a_rule_is_refused)
{
    const auto refusal = [&](auto change) {
        Light light = model.lights[1];
        change(light);
        return model.set_light(1, light).value_or("");
    };
    EXPECT_EQ(refusal([](Light& l) { l.name = "sun"; }), "another light is called sun");
    EXPECT_NE(refusal([](Light& l) { l.name = "12"; }), "");
    EXPECT_NE(refusal([](Light& l) { l.type = LightType::rect, l.direction = vec3(0); }), "");
    EXPECT_NE(refusal([](Light& l) { l.type = LightType::spot, l.inner = 50; }), "");
    EXPECT_EQ(model.lights, (model.undo(), model.lights));
    EXPECT_EQ(model.lights[1].name, "light1");
    EXPECT_EQ(refusal([](Light& l) { l.name = "key"; }), "");
    EXPECT_EQ(model.lights[1].name, "key");
    EXPECT_EQ(refusal([](Light& l) { l.name = ""; }), "");
    EXPECT_EQ(model.lights[1].name, "light2");
}

TEST_F(view_model, a_reset_that_is_refused_changes_nothing)
{
    std::vector<Light> twice = two_lights();
    twice[1].name = "sun";
    test::expect_error([&] { model.reset(Settings{}, Camera{}, twice); }, ExitCode::usage, "sun");
    EXPECT_EQ(model.settings.ao.radius, 1.0f / 3.0f);
    EXPECT_EQ(model.lights[1].name, "light1");
}

TEST_F(view_model, settings_go_to_a_file_and_come_back)
{
    const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "atrium-settings.toml";
    model.settings.ao.radius = 1.25f;
    model.settings.shadow.filter = ShadowFilter::pcf;
    model.save_settings(file);
    const std::string saved = model.settings_toml();
    model.settings = Settings{};
    model.settings.ao.power = 3; // which the file leaves at its default
    model.checkpoint();
    EXPECT_EQ(model.load_settings(file), std::nullopt);
    EXPECT_EQ(model.settings_toml(), saved);
    model.undo();
    EXPECT_EQ(model.settings.ao.power, 3);

    std::ofstream(file) << "[settings]\nao.radius = 2.0\nao.radios = 1.0\n";
    const auto refused = model.load_settings(file);
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->find("atrium-settings.toml:3"), std::string::npos) << *refused;
    EXPECT_NE(refused->find("ao.radius"), std::string::npos) << *refused;
    EXPECT_EQ(model.settings.ao.power, 3);
    std::filesystem::remove(file);
    EXPECT_TRUE(model.load_settings(file)); // is not there
    EXPECT_THROW(model.save_settings("/nowhere/at/all.toml"), Error);
}

} // namespace
} // namespace atrium::gui
