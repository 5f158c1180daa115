// Materials, picked and changed in the window by real clicks.

#include "tests/window/viewed.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace atrium::window {
namespace {

std::string bytes_of(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(in)), {});
}

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
    const ivec2 materials{230, 140}, floor{700, 520}, nothing{390, 550};
    desktop->click(window, materials);
    ASSERT_TRUE(settle());
    const Image8 unmarked = scene();
    EXPECT_GT(late_change([&] { desktop->click(window, floor); }), 0.02); // the line around it
    desktop->move(window, nothing);
    ASSERT_TRUE(settle());
    picture("window-materials");

    const Image8 start = scene();
    const ivec2 red_from{95, 490}, red_to{30, 490};
    EXPECT_GT(late_change([&] { desktop->drag(window, red_from, red_to); }), 0.02);
    desktop->tap("F12");
    const fs::path shot = folder / "atrium.0000.png", again = folder / "again.png";
    for (int i = 0; i < 100 && !fs::exists(shot); ++i) std::this_thread::sleep_for(100ms);
    ASSERT_TRUE(fs::exists(shot));
    const std::string command = std::string(ATRIUM_BIN) + "/atrium render " +
                                (folder / "courtyard" / "courtyard.toml").string() + " --config " + shot.string() +
                                " -o " + again.string() + " --quiet";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_TRUE(bytes_of(shot) == bytes_of(again));
    EXPECT_NE(bytes_of(shot).find("[[material]]"), std::string::npos);

    EXPECT_GT(late_change([] { desktop->tap("z", "Control_L"); }), 0.02);
    EXPECT_EQ(mean_difference(start, scene()), 0);
    EXPECT_GT(late_change([] { desktop->click(window, {289, 194}); }), 0.02); // another tab, below the message
    EXPECT_EQ(mean_difference(unmarked, scene()), 0);
}

} // namespace
} // namespace atrium::window
