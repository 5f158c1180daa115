#include "app/gui/split_view.hpp"
#include "tests/gui/headless.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace atrium::gui {
namespace {

using test::HeadlessGui;

TEST(split_view, tells_what_the_sides_differ_in)
{
    Settings first, second;
    EXPECT_TRUE(differences(first, second).empty());
    second.shadow.samples = 7;
    second.ao.method = AoMethod::off;
    first.ao.method = AoMethod::gtao;
    const std::vector<std::string> lines = differences(first, second);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0], "ao.method: gtao | off");
    EXPECT_EQ(lines[1], "shadow.samples: " + std::to_string(first.shadow.samples) + " | 7");
}

/// A split view with its divider in the middle.
class divider : public ::testing::Test {
protected:
    divider()
    {
        model.split = Split{model.settings};
        gui.frame(draw, false);
    }
    HeadlessGui gui{800, 600};
    ViewModel model;
    FrameFacts facts;
    std::function<void()> draw = [this] { draw_divider(model, facts, 1); };
};

TEST_F(divider, follows_the_mouse_and_stays_within_the_window)
{
    const auto drag_to = [&](float x) {
        const float from = model.split->divider * 800;
        gui.mouse(from, 300, false);
        gui.frame(draw, false);
        gui.mouse(from, 300, true);
        gui.frame(draw, false);
        gui.mouse(x, 300, true);
        gui.frame(draw, false);
        gui.mouse(x, 300, false);
        gui.frame(draw, false);
    };
    drag_to(600);
    EXPECT_FLOAT_EQ(model.split->divider, 0.75f);
    drag_to(-50);
    EXPECT_FLOAT_EQ(model.split->divider, 0.02f);
    drag_to(2000);
    EXPECT_FLOAT_EQ(model.split->divider, 0.98f);
    gui.mouse(100, 100, false);
    gui.frame(draw, false);
    EXPECT_TRUE(gui.cut_off().empty());
}

TEST_F(divider, stays_when_the_press_is_beside_it)
{
    gui.click(300, 300, draw, false);
    EXPECT_FLOAT_EQ(model.split->divider, 0.5f);
}

} // namespace
} // namespace atrium::gui
