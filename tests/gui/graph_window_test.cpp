// The window of the frame's graph: its size, what clicks do, what it costs.

#include "app/gui/graph_window.hpp"
#include "app/gui/panels.hpp"
#include "tests/gui/graph_of_frame.hpp"
#include "tests/gui/headless.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <algorithm>

namespace atrium::gui {
namespace {

using test::HeadlessGui;

struct Window : ::testing::Test {
    Window()
    {
        frame.image("depth");
        frame.image("hdr");
        frame.pass("draw", {}, {"depth"});
        frame.pass("light", {"depth"}, {"hdr"});
        frame.pass("show", {"hdr"}, {});
        window.open = true;
    }
    void draw(const HeadlessGui& gui, int frames = 3)
    {
        for (int i = 0; i < frames; ++i) gui.frame(drawing, false);
    }
    /// The middle of a box, on the screen.
    [[nodiscard]] vec2 middle_of(const std::string& image) const
    {
        for (std::size_t i = 0; i < window.drawing.boxes.size(); ++i) {
            const auto resource = window.drawing.boxes[i].image;
            if (!resource || frame.facts.resources[*resource].name != image) continue;
            return window.canvas + window.origin + window.zoom * (window.corners[i] + 0.5f * window.sizes[i]);
        }
        ADD_FAILURE() << image;
        return {};
    }
    test::GraphOfFrame frame;
    ViewModel model;
    GraphWindow window;
    std::function<void()> drawing = [this] { draw_graph_window(model, frame.facts, nullptr, window, 1); };
};

using graph_window = Window;

TEST_F(graph_window, a_click_on_an_image_pins_it_and_another_one_ends_that)
{
    const HeadlessGui gui(1280, 720);
    draw(gui);
    const vec2 at = middle_of("hdr");
    gui.click(at.x, at.y, drawing, false);
    ASSERT_EQ(model.pinned.size(), 1u);
    EXPECT_EQ(model.pinned[0].name, "graph.hdr");
    EXPECT_EQ(model.settings.debug.view, "");
    gui.click(at.x, at.y, drawing, false);
    EXPECT_TRUE(model.pinned.empty());
}

TEST_F(graph_window, a_drag_moves_the_drawing_and_pins_nothing)
{
    const HeadlessGui gui(1280, 720);
    draw(gui);
    const vec2 at = middle_of("hdr"), before = window.origin;
    gui.mouse(at.x, at.y, true);
    draw(gui);
    gui.mouse(at.x + 50, at.y - 20, true);
    draw(gui);
    gui.mouse(at.x + 50, at.y - 20, false);
    draw(gui);
    EXPECT_EQ(window.origin, before + vec2(50, -20));
    EXPECT_TRUE(model.pinned.empty());
}

TEST_F(graph_window, the_wheel_scales_about_the_mouse)
{
    const HeadlessGui gui(1280, 720);
    draw(gui);
    const vec2 at = middle_of("depth");
    const float before = window.zoom;
    gui.mouse(at.x, at.y, false);
    draw(gui);
    ImGui::GetIO().MouseWheel = -1;
    draw(gui, 1);
    EXPECT_LT(window.zoom, before);
    const vec2 moved = glm::abs(middle_of("depth") - at);
    EXPECT_LT(std::max(moved.x, moved.y), 0.1f);
}

TEST_F(graph_window, what_the_mouse_points_at_stays_there_when_the_graph_changes)
{
    const HeadlessGui gui(1280, 720);
    draw(gui);
    const vec2 at = middle_of("hdr");
    gui.mouse(at.x, at.y, false);
    draw(gui);
    frame.image("bloom");
    frame.pass("bright", {"depth"}, {"bloom"});
    frame.pass("blur", {"bloom"}, {});
    draw(gui);
    const vec2 moved = glm::abs(middle_of("hdr") - at);
    EXPECT_LT(std::max(moved.x, moved.y), 0.1f);
}

TEST_F(graph_window, fits_small_and_large_displays_beside_the_panel)
{
    for (const vec2 size : {vec2(800, 600), vec2(1280, 720), vec2(3840, 2160)}) {
        const HeadlessGui gui(size.x, size.y);
        window = {};
        window.open = true;
        draw(gui);
        EXPECT_EQ(gui.cut_off(), std::vector<std::string>{}) << size.x;
        EXPECT_GE(window.canvas.x, std::min(panel_width, 0.5f * size.x)) << size.x;
    }
}

TEST_F(graph_window, costs_nothing_when_closed_and_little_when_open)
{
    const HeadlessGui gui(1280, 720);
    frame.facts = {};
    for (int i = 0; i < 20; ++i) frame.image(fmt::format("image{}", i));
    for (int p = 0; p < 60; ++p) {
        std::vector<std::string> reads;
        for (int i = 1; i <= 6 && p >= i; ++i) reads.push_back(fmt::format("image{}", (p - i) % 20));
        frame.pass(fmt::format("pass{}", p), reads, {fmt::format("image{}", p % 20)});
    }
    draw(gui);
    EXPECT_GT(gui.vertices(), 1000);
    EXPECT_LT(gui.vertices(), 60000);
    window.open = false;
    draw(gui);
    EXPECT_EQ(gui.vertices(), 0);
}

TEST_F(graph_window, bears_a_frame_without_a_graph)
{
    const HeadlessGui gui(800, 600);
    frame.facts = {};
    draw(gui);
    EXPECT_EQ(gui.cut_off(), std::vector<std::string>{});
}

} // namespace
} // namespace atrium::gui
