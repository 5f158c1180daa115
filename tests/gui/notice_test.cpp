// Notes over the picture: whole at every size, and their button is heard.

#include "app/gui/notice.hpp"
#include "tests/gui/headless.hpp"

#include <gtest/gtest.h>

namespace atrium::gui {
namespace {

const std::string text =
    "techniques/tonemap/tonemap.frag does not compile\n  where: techniques/tonemap/tonemap.frag:12";

TEST(notice, is_never_cut_off)
{
    for (const auto& [width, height] : {std::pair{320.0f, 200.0f}, {800.0f, 600.0f}, {2560.0f, 1440.0f}}) {
        for (const float scale : {1.0f, 1.5f}) {
            const test::HeadlessGui gui(width, height, scale);
            for (int i = 0; i < 3; ++i) // sizes itself in the first
                gui.frame([&] { draw_notice(Corner::bottom_right, text, nullptr, scale); }, false);
            EXPECT_TRUE(gui.cut_off().empty()) << width << " x " << height << " at " << scale;
        }
    }
}

TEST(notice, tells_when_its_button_is_pressed)
{
    const test::HeadlessGui gui(1280, 720);
    int pressed = 0;
    const auto draw = [&] { pressed += draw_notice(Corner::top_right, "Baking court.obj", "Cancel", 1) ? 1 : 0; };
    gui.frame(draw, false);
    gui.frame(draw, false);
    EXPECT_EQ(pressed, 0);
    gui.click(1280 - 8 - 520 + 25, 48, draw, false); // under the line of text
    EXPECT_EQ(pressed, 1);
}

} // namespace
} // namespace atrium::gui
