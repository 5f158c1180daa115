#include "app/gui/material_panel.hpp"

#include "app/toml_text.hpp"
#include "renderer/scene/scene_file.hpp"
#include "tests/gui/headless.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace atrium::gui {
namespace {

using test::HeadlessGui;

struct Fixture : ::testing::Test {
    ViewModel model;
    SceneFacts facts;
    MaterialTab tab;

    Fixture()
    {
        for (const char* name : {"stone", "red cloth", "Stone, wet"}) {
            Material material;
            material.name = name;
            model.scene_materials.push_back(material);
        }
        facts.materials.resize(3);
        facts.materials[1].image = 5;
        facts.materials[1].textures = {{"base color", "red.png", "rgba8_srgb", {64, 64}, 21845}};
        model.reset(Settings{}, Camera{}, {});
    }
    void change(std::size_t index, float roughness)
    {
        Material material = model.material(index);
        material.roughness = roughness;
        model.set_material(index, material);
        model.checkpoint();
    }
    void draw() { draw_material_tab(model, facts, tab, true); }
};
using material_panel = Fixture;

TEST_F(material_panel, changes_are_undone_redone_and_reset)
{
    change(0, 0.5f);
    change(0, 0.25f);
    EXPECT_EQ(model.materials.size(), 1u);
    EXPECT_EQ(model.material(0).roughness, 0.25f);
    EXPECT_EQ(model.material(2).roughness, 1.0f);
    model.undo();
    EXPECT_EQ(model.material(0).roughness, 0.5f);
    model.redo();
    EXPECT_EQ(model.material(0).roughness, 0.25f);
    change(0, 1); // what the scene says
    EXPECT_TRUE(model.materials.empty());
    while (model.can_undo()) model.undo();
    EXPECT_TRUE(model.materials.empty());
}

TEST_F(material_panel, changes_go_to_a_file_and_come_back)
{
    Material cloth = model.material(1);
    cloth.cls = MaterialClass::cloth;
    cloth.base_color = {0.1f, 1.0f / 3.0f, 0};
    cloth.two_sided = true;
    model.set_material(1, cloth);
    const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "atrium-materials.toml";
    model.save_settings(file);
    const auto saved = model.materials;
    model.materials.clear();
    EXPECT_EQ(model.load_settings(file), std::nullopt);
    EXPECT_EQ(model.materials, saved);
    EXPECT_EQ(model.material(1).base_color, cloth.base_color);
    std::filesystem::remove(file);
}

TEST_F(material_panel, a_click_on_a_line_selects_among_those_that_are_searched)
{
    const HeadlessGui gui(360, 600);
    const float first = 60, pitch = 38;
    gui.click(150, first, [&] { draw(); });
    EXPECT_EQ(model.selected_material, 0u);
    gui.click(150, first + pitch, [&] { draw(); });
    EXPECT_EQ(model.selected_material, 1u);
    tab.filter = "sTONE";
    gui.click(150, first + pitch, [&] { draw(); });
    EXPECT_EQ(model.selected_material, 2u);
    EXPECT_FALSE(model.can_undo()); // a selection changes nothing
}

TEST_F(material_panel, a_slider_changes_the_selected_material_alone)
{
    const HeadlessGui gui(360, 900);
    model.selected_material = 1;
    for (float y = 220; y < 800 && model.materials.empty(); y += 5) {
        gui.mouse(250, y, false);
        gui.frame([&] { draw(); });
        for (const float x : {250.0f, 160.0f, 155.0f}) {
            gui.mouse(x, y, true);
            gui.frame([&] { draw(); });
        }
        gui.mouse(155, y, false);
        gui.frame([&] { draw(); });
    }
    ASSERT_EQ(model.materials.size(), 1u) << "no slider was hit";
    EXPECT_EQ(model.materials[0].match, "red cloth");
    EXPECT_EQ(model.materials[0].values.size(), 1u);
}

TEST_F(material_panel, is_empty_without_a_scene_and_bears_a_selection_that_is_gone)
{
    const HeadlessGui gui(360, 600);
    model.selected_material = 7;
    gui.frame([&] { draw(); });
    EXPECT_FALSE(model.selected_material.has_value());
    facts.materials.clear();
    model.scene_materials.clear();
    gui.frame([&] { draw(); });
}

} // namespace
} // namespace atrium::gui
