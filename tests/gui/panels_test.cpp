#include "app/gui/panels.hpp"

#include "app/presets.hpp"
#include "tests/gui/headless.hpp"

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <functional>
#include <string>
#include <vector>

namespace atrium::gui {
namespace {

using test::HeadlessGui;

constexpr Tab all_tabs[]{Tab::settings, Tab::lights, Tab::buffers, Tab::camera, Tab::materials, Tab::costs, Tab::help};

FrameFacts busy_frame()
{
    FrameFacts facts;
    facts.device = "A device with quite a long name (version 21.1.8, 256 bits) of some driver";
    facts.size = {1920, 1080};
    FrameCost cost;
    cost.frame_ms = 123.4;
    for (int i = 0; i < 40; ++i)
        cost.passes.push_back({"visibility.a_light_of_a_long_name_" + std::to_string(i), 0.1 * i, 123456, 2.0 * i});
    for (std::size_t i = 0; i < CostHistory::longest; ++i) facts.costs.add(cost);
    facts.heaps = {{true, 3'000'000'000, 9'000'000'000}, {false, 12, 9'000'000'000}};
    facts.triangles = 12'345'678;
    facts.scene.materials.resize(40);
    for (MaterialFacts& material : facts.scene.materials) {
        material.triangles = 1'234'567;
        material.textures = {{"base color", "a/rather/long/path/of/folders/to/the/texture.png", "rgba8_srgb"}};
    }
    return facts;
}

void fill(ViewModel& model, PanelState& state)
{
    model.scene_name = "a/rather/long/path/of/folders/to/the/scene/that/is/shown/courtyard.toml";
    for (const LightType type : {LightType::sun, LightType::spot, LightType::point, LightType::rect})
        model.add_light(type, vec3(1));
    for (int i = 0; i < 20; ++i) model.duplicate_selected();
    model.scene_file.cameras = {{"hero", {}}, {"a camera of a name that is longer than the panel is wide", {}}};
    for (int i = 0; i < 20; ++i) EXPECT_EQ(add_bookmark(model.bookmarks, "", Camera{}), std::nullopt);
    for (std::string name : {"", "walk", "a path of a name that is longer than the panel is wide"})
        EXPECT_EQ(add_path(model.paths, name, Camera{}), std::nullopt);
    for (int i = 1; i < 20; ++i) static_cast<void>(add_key(model.paths["walk"], static_cast<float>(i), Camera{}));
    model.scene_materials.resize(40);
    for (Material& material : model.scene_materials)
        material.name = "a_material_of_a_name_that_is_longer_than_the_panel";
    for (int i = 0; i < 40; ++i)
        state.keys.push_back({"Ctrl + Shift + drag", "move the selected light along the view", "move"});
}

struct At {
    float width, height, scale;
};
struct Sizes : ::testing::TestWithParam<At> {};
INSTANTIATE_TEST_SUITE_P(panels, Sizes,
                         ::testing::Values(At{800, 600, 1}, At{1920, 1080, 1}, At{3840, 2160, 2}, At{800, 600, 1.5f},
                                           At{640, 480, 1}, At{320, 240, 1}));

TEST_P(Sizes, every_tab_fits)
{
    const auto [width, height, scale] = GetParam();
    const HeadlessGui gui(width, height, scale);
    for (const bool busy : {false, true}) {
        ViewModel model;
        PanelState state;
        state.scale = scale;
        FrameFacts facts;
        if (busy) {
            facts = busy_frame();
            fill(model, state);
        }
        const auto draw = [&] { draw_panels(model, facts, state); };
        for (const Tab tab : all_tabs) {
            for (std::size_t selected = 0; selected < 4; ++selected) { // each type of light
                if (busy) model.selected = selected;
                if (busy) state.camera = state.path.path = state.path.key = selected;
                if (busy && selected > 0) model.selected_material = selected;
                state.show = tab;
                state.headings = Headings::open;
                for (int frame = 0; frame < 4; ++frame) gui.frame(draw, false);
                EXPECT_EQ(gui.cut_off(), std::vector<std::string>{}) << "tab " << static_cast<int>(tab);
                EXPECT_GT(gui.vertices(), 100);
                EXPECT_FALSE(state.show.has_value());
            }
        }
        EXPECT_TRUE(model.list.differing().empty());
        EXPECT_EQ(model.can_undo(), busy); // lights were added
    }
}

TEST(panels, tabs_show_their_names_whole)
{
    for (const float scale : {1.0f, 1.25f, 1.5f, 1.75f, 2.0f}) {
        const HeadlessGui gui(800 * scale, 600 * scale, scale);
        ViewModel model;
        PanelState state;
        state.scale = scale;
        for (int frame = 0; frame < 2; ++frame) gui.frame([&] { draw_panels(model, FrameFacts{}, state); }, false);
        EXPECT_EQ(gui.lacking_tab_width(), 0) << scale;
    }
}

TEST(panels, no_wider_than_said)
{
    const HeadlessGui gui(800, 600);
    ViewModel model;
    PanelState state;
    ImVec2 before, after;
    gui.frame([&] { draw_panels(model, busy_frame(), state); }, false);
    gui.frame(
        [&] {
            draw_panels(model, busy_frame(), state);
            ImGui::Begin("Atrium");
            before = ImGui::GetWindowPos();
            after = {before.x + ImGui::GetWindowWidth(), before.y + ImGui::GetWindowHeight()};
            ImGui::End();
        },
        false);
    EXPECT_LE(after.x - before.x, panel_width);
    EXPECT_GE(before.x, 0.0f);
    EXPECT_LE(after.y, 600.0f);
}

/// Sweeps the mouse over the panel, clicking everywhere: nothing may break, whatever is hit.
TEST(panels, clicks_anywhere_leave_a_scene_that_can_be_drawn)
{
    const HeadlessGui gui(800, 600);
    ViewModel model;
    PanelState state;
    fill(model, state);
    state.settings_file = state.path.file = ""; // which no click can write
    FrameFacts facts = busy_frame();
    const auto draw = [&] { draw_panels(model, facts, state); };
    for (const Tab tab : all_tabs) {
        state.headings = Headings::open;
        for (float y = 150; y < 590; y += 17) {
            for (float x = 16; x < panel_width; x += 29) {
                state.show = tab;
                gui.click(x, y, draw, false);
            }
        }
    }
    for (int frame = 0; frame < 3; ++frame) gui.frame(draw, false);
    for (const Setting& s : model.list.all()) EXPECT_FALSE(s.set_text(s.get()).has_value()) << s.key;
    for (const Light& light : model.lights) EXPECT_NO_THROW(check_light(light, ExitCode::usage, "")) << to_spec(light);
    EXPECT_NO_THROW(name_lights(model.lights));
    EXPECT_NO_THROW(check_camera(model.camera, ExitCode::usage, ""));
    EXPECT_TRUE(model.can_undo());
    while (model.can_undo()) model.undo();
    EXPECT_TRUE(model.list.differing().empty());
    EXPECT_TRUE(model.lights.empty());
    EXPECT_TRUE(model.materials.empty());
}

/// Presses at each height in turn and drags to the right, until `done`; then lets go.
template <class Done>
void drag_somewhere(const HeadlessGui& gui, const std::function<void()>& draw, float to_x, const Done& done)
{
    bool found = false;
    for (float y = 170; y < 580 && !found; y += 9) {
        gui.mouse(230, y, false);
        gui.frame(draw, false);
        for (const float x : {230.0f, 0.5f * (230.0f + to_x), to_x}) {
            gui.mouse(x, y, true);
            gui.frame(draw, false);
        }
        found = done();
        gui.mouse(to_x, y, false);
        gui.frame(draw, false);
        gui.frame(draw, false);
    }
    EXPECT_TRUE(found) << "nothing was hit";
}

TEST(panels, a_drag_is_one_step_to_undo)
{
    const HeadlessGui gui(800, 600);
    ViewModel model;
    PanelState state;
    state.filter = "ao.radius"; // the only widget below the buttons
    drag_somewhere(
        gui, [&] { draw_panels(model, FrameFacts{}, state); }, 300,
        [&] { return model.settings.ao.radius != Settings{}.ao.radius; });
    ASSERT_TRUE(model.can_undo());
    model.undo();
    EXPECT_EQ(model.settings.ao.radius, Settings{}.ao.radius);
    EXPECT_FALSE(model.can_undo());
}

TEST(panels, a_message_moves_nothing_that_is_about_to_be_clicked)
{
    /// Whether a click there goes into the search box, below a message of so many words.
    const auto searches_at = [](float y, int words) {
        const HeadlessGui gui(800, 600);
        ViewModel model;
        PanelState state;
        for (int i = 0; i < words; ++i) state.message += "word ";
        const auto draw = [&] { draw_panels(model, FrameFacts{}, state); };
        for (int frame = 0; frame < 3; ++frame) gui.frame(draw, false);
        EXPECT_EQ(gui.cut_off(), std::vector<std::string>{}) << words;
        gui.click(100, y, draw, false);
        gui.type("ao");
        gui.frame(draw, false);
        return state.filter == "ao";
    };
    float y = 40;
    while (y < 300 && !searches_at(y, 0)) y += 4;
    for (const int words : {5, 100, 2000}) EXPECT_TRUE(searches_at(y, words)) << words;
}

TEST(panels, an_edit_that_breaks_a_rule_of_lights_is_refused_and_said)
{
    const HeadlessGui gui(800, 600);
    ViewModel model;
    PanelState state;
    model.add_light(LightType::spot, vec3(0));
    state.show = Tab::lights;
    drag_somewhere(
        gui, [&] { draw_panels(model, FrameFacts{}, state); }, 3000, // the inner angle beyond the outer one
        [&] { return state.message.find("inner") != std::string::npos; });
    EXPECT_LE(model.lights[0].inner, model.lights[0].outer);
}

TEST(panels, a_selection_that_is_gone_is_no_harm)
{
    const HeadlessGui gui(800, 600);
    ViewModel model;
    PanelState state;
    model.selected = 7;
    state.show = Tab::lights;
    state.message = "Something was refused.";
    for (int frame = 0; frame < 3; ++frame) gui.frame([&] { draw_panels(model, FrameFacts{}, state); }, false);
    EXPECT_FALSE(model.selected.has_value());
}

TEST(panels, every_preset_can_be_applied)
{
    ViewModel model;
    EXPECT_FALSE(app::preset_names().empty());
    for (const std::string& name : app::preset_names()) {
        EXPECT_EQ(model.apply_texts(app::preset_settings(name)), std::nullopt) << name;
    }
}

TEST(panels, presets_of_quality_replace_each_other)
{
    const auto keys_of = [](const char* preset) {
        std::vector<std::string> keys;
        for (const SettingText& text : app::preset_settings(preset)) keys.push_back(text.key);
        return keys;
    };
    for (const char* preset : {"medium", "high", "reference"}) EXPECT_EQ(keys_of(preset), keys_of("low")) << preset;
}

TEST(panels, the_cpu_preset_is_what_a_cpu_begins_with)
{
    ViewModel preset, defaults;
    ASSERT_EQ(preset.apply_texts(app::preset_settings("cpu")), std::nullopt);
    defaults.apply_defaults(true);
    EXPECT_EQ(preset.settings_toml(), defaults.settings_toml());
}

TEST(panels, the_camera_as_options)
{
    EXPECT_EQ(camera_options({{-11.5f, 1.7f, 0}, {10, 3.5f, -0.4f}, 60}),
              "--eye -11.5,1.7,0 --target 10,3.5,-0.4 --fov 60");
}

} // namespace
} // namespace atrium::gui
