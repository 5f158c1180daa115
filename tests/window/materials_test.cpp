// Materials, picked and changed in the window by real clicks.

#include "tests/window/tabs.hpp"
#include "tests/window/viewed.hpp"

#include <gtest/gtest.h>

namespace atrium::window {
namespace {

class Materials : public ViewedProgram {
protected:
    static void SetUpTestSuite()
    {
        ViewedProgram::SetUpTestSuite();
        start(hero());
    }
    /// change(), of what may take a while to begin: the first pick makes pipelines.
    template <class F>
    static double late_change(F&& act)
    {
        const Image8 before = scene();
        act();
        for (int i = 0; i < 100 && mean_difference(before, scene()) == 0; ++i) std::this_thread::sleep_for(100ms);
        EXPECT_TRUE(settle());
        return mean_difference(before, scene());
    }
};

TEST_F(Materials, are_picked_by_a_click_changed_undone_and_drawn_again)
{
    const ivec2 step{700, 520}, nothing{390, 550};
    desktop->click(window, tabs::materials);
    ASSERT_TRUE(settle());
    const Image8 unmarked = scene();
    EXPECT_GT(late_change([&] { desktop->click(window, step); }), 0.02); // the line around it
    desktop->move(window, nothing);
    ASSERT_TRUE(settle());
    picture("window-materials");

    const Image8 start = scene();
    const ivec2 red_from{95, 476}, red_to{30, 476};
    EXPECT_GT(late_change([&] { desktop->drag(window, red_from, red_to); }), 0.02);
    desktop->tap("F12");
    const fs::path shot = folder / "atrium.0000.png";
    EXPECT_TRUE(is_drawn_again(shot));
    EXPECT_NE(bytes_of(shot).find("[[material]]"), std::string::npos);

    EXPECT_GT(late_change([] { desktop->tap("z", "Control_L"); }), 0.02);
    EXPECT_EQ(mean_difference(start, scene()), 0);
    EXPECT_GT(late_change([] { desktop->click(window, tabs::costs); }), 0.02);
    EXPECT_EQ(mean_difference(unmarked, scene()), 0);
}

} // namespace
} // namespace atrium::window
