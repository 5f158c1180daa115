// Buffers in the window: the list, the pinned ones, the values under the mouse.

#include "app/gui/graph_images.hpp"
#include "app/gui/inset_layout.hpp"
#include "app/gui/panels.hpp"
#include "tests/gui/headless.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace atrium::gui {
namespace {

using test::HeadlessGui;

bool offers(const ViewModel& model, const std::string& name)
{
    const std::vector<std::string> names = model.offered_buffers();
    return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(buffers, offered_are_those_of_techniques_that_are_on)
{
    ViewModel model;
    model.settings.ao.method = AoMethod::off;
    EXPECT_FALSE(offers(model, "ao"));
    model.settings.ao.method = AoMethod::gtao;
    EXPECT_TRUE(offers(model, "ao"));
    ASSERT_TRUE(model.add_light(LightType::point, vec3(0)));
    const std::string name = model.lights[0].name;
    model.settings.shadow.filter = ShadowFilter::hard;
    EXPECT_TRUE(offers(model, "light." + name));
    EXPECT_TRUE(offers(model, "visibility." + name));
    model.lights[0].shadow = false;
    EXPECT_FALSE(offers(model, "visibility." + name));
    for (const std::string& offered : model.offered_buffers()) EXPECT_TRUE(parse_aov(offered, model.lights).info);
}

TEST(buffers, steps_go_round_through_the_picture)
{
    ViewModel model;
    const std::vector<std::string> names = model.offered_buffers();
    for (const std::string& name : names) {
        model.step_buffer(1);
        EXPECT_EQ(model.settings.debug.view, name);
    }
    model.step_buffer(1);
    EXPECT_EQ(model.settings.debug.view, "");
    model.step_buffer(-1);
    EXPECT_EQ(model.settings.debug.view, names.back());
    model.settings.debug.view = "light.gone";
    model.step_buffer(1);
    EXPECT_EQ(model.settings.debug.view, "");
}

TEST(buffers, of_a_light_by_its_index_is_the_one_by_its_name)
{
    ViewModel model;
    model.add_light(LightType::point, vec3(0));
    const std::string name = "light." + model.lights[0].name;
    model.settings.debug.view = name;
    model.step_buffer(1);
    const std::string next = model.settings.debug.view;
    model.settings.debug.view = "light.0";
    EXPECT_EQ(model.shown_buffer(), name);
    model.step_buffer(1);
    EXPECT_EQ(model.settings.debug.view, next);
    model.settings.debug.view = "light.7";
    EXPECT_EQ(model.shown_buffer(), "");
}

TEST(buffers, go_with_their_light_s_name_and_end_with_it)
{
    ViewModel model;
    model.add_light(LightType::point, vec3(0));
    model.settings.debug.view = "light.0";
    model.toggle_pin("visibility." + model.lights[0].name);
    Light renamed = model.lights[0];
    renamed.name = "lamp";
    EXPECT_EQ(model.set_light(0, renamed), std::nullopt);
    EXPECT_EQ(model.settings.debug.view, "light.lamp");
    EXPECT_EQ(model.pinned.at(0).name, "visibility.lamp");
    model.checkpoint();
    model.remove_selected();
    EXPECT_EQ(model.settings.debug.view, "");
    model.checkpoint();
    model.undo(); // in one step
    EXPECT_EQ(model.shown_buffer(), "light.lamp");
}

TEST(buffers, pins_go_with_their_lights_and_have_an_end)
{
    ViewModel model;
    model.add_light(LightType::point, vec3(0));
    model.toggle_pin("light." + model.lights[0].name);
    model.toggle_pin("depth");
    model.lights.clear();
    model.drop_lost_buffers();
    ASSERT_EQ(model.pinned.size(), 1u);
    EXPECT_EQ(model.pinned[0].name, "depth");
    model.toggle_pin("depth");
    EXPECT_TRUE(model.pinned.empty());
    for (const std::string& name : model.offered_buffers()) model.toggle_pin(name);
    EXPECT_EQ(model.pinned.size(), max_insets);
}

TEST(buffers, images_of_the_graph_are_offered_by_layer_and_outlive_their_technique)
{
    GraphFacts graph;
    graph.resources.resize(2);
    graph.resources[0].name = "readback";
    graph.resources[1].name = "visibility";
    graph.resources[1].layers = 2;
    graph.resources[1].can_be_shown = true;
    const std::vector<std::string> names = buffers_of(graph);
    EXPECT_EQ(names, (std::vector<std::string>{"graph.visibility", "graph.visibility:1"}));
    ViewModel model;
    model.graph_images = names;
    for (const std::string& name : names) {
        EXPECT_TRUE(offers(model, name));
        model.settings.debug.view = name;
        EXPECT_EQ(model.shown_buffer(), name);
        model.toggle_pin(name);
    }
    model.graph_images.clear();
    model.drop_lost_buffers();
    EXPECT_FALSE(offers(model, names[0]));
    EXPECT_EQ(model.pinned.size(), 2u);
}

TEST(buffers, insets_stand_beside_the_panel_and_apart)
{
    for (const uvec2 window : {uvec2(800, 600), uvec2(1280, 720), uvec2(3840, 2160)}) {
        for (std::size_t count = 1; count <= max_insets; ++count) {
            const HeadlessGui gui(static_cast<float>(window.x), static_cast<float>(window.y));
            ViewModel model;
            for (std::size_t i = 0; i < count; ++i) model.toggle_pin(model.offered_buffers()[i]);
            for (int i = 0; i < 3; ++i) gui.frame([&] { draw_buffers(model, {}, 1); }, false);
            EXPECT_EQ(gui.cut_off(), std::vector<std::string>{}) << window.x << " " << count;
            const InsetLayout layout = lay_out_insets(window, 1, count);
            EXPECT_GE(layout.origin.x, static_cast<std::uint32_t>(panel_width));
            EXPECT_GT(layout.step.x, layout.image.x);
            EXPECT_GT(layout.step.y, layout.image.y);
            EXPECT_EQ(layout.with_legend, layout.image.x >= 150);
            EXPECT_GE(layout.image.x, 90u);
        }
    }
    EXPECT_TRUE(lay_out_insets({800, 600}, 1, 2).with_legend);
    EXPECT_GE(lay_out_insets({320, 200}, 1, max_insets).image.x, 1u); // the smallest window: no harm
}

struct Overlay : ::testing::Test {
    Overlay() : gui(800, 600)
    {
        facts.buffers = {{"depth", {}}};
        facts.buffer_value = [this](std::size_t, vec2 at) {
            asked = at;
            return std::vector<float>{1};
        };
    }
    void draw(int frames = 4) const
    {
        for (int i = 0; i < frames; ++i) gui.frame(drawing, false);
    }
    HeadlessGui gui;
    mutable ViewModel model;
    mutable FrameFacts facts;
    mutable vec2 asked{-1};
    std::function<void()> drawing = [this] { draw_buffers(model, facts, 1); };
};

using buffer_overlay = Overlay;

TEST_F(buffer_overlay, a_click_enlarges_and_the_button_removes)
{
    model.toggle_pin("depth");
    model.toggle_pin("normal");
    draw();
    EXPECT_EQ(gui.cut_off(), std::vector<std::string>{});
    gui.click(480, 460, drawing, false);
    EXPECT_EQ(model.settings.debug.view, "depth");
    EXPECT_EQ(model.pinned.size(), 2u);
}

TEST_F(buffer_overlay, says_that_there_is_no_such_image)
{
    model.settings.debug.view = "graph.ao.raw";
    model.toggle_pin("graph.ao.raw");
    facts.buffers = {{"graph.ao.raw", {}}, {"graph.ao.raw", {}}};
    draw();
    const int without = gui.vertices();
    for (ShownBuffer& b : facts.buffers) b.facts.absent = true;
    draw();
    EXPECT_GT(gui.vertices(), without + 2 * 4 * 30); // a sentence, twice
    EXPECT_EQ(gui.cut_off(), std::vector<std::string>{});
}

TEST_F(buffer_overlay, asks_for_the_value_under_the_mouse)
{
    model.settings.debug.view = "depth";
    gui.mouse(600, 300, false);
    draw();
    EXPECT_EQ(asked, vec2(0.75f, 0.5f));
    gui.mouse(700, 40, false); // over the legend
    asked = vec2(-1);
    draw();
    EXPECT_EQ(asked, vec2(-1));
    gui.mouse(600, 300, false); // at the side that shows other settings
    model.split = Split{model.settings, 0.9f};
    draw();
    EXPECT_EQ(asked, vec2(-1));
}

} // namespace
} // namespace atrium::gui
