// Techniques changed by their widgets, and presets: in the tab of settings, which a window begins with.

#include "tests/window/viewed.hpp"

#include <string>
#include <vector>

namespace atrium::window {
namespace {

class ChangedSettings : public ViewedProgram {
protected:
    static void SetUpTestSuite()
    {
        ViewedProgram::SetUpTestSuite();
        start(hero());
    }
    /// Leaves the one setting in the panel that has the text in its name.
    static void seek(const std::string& text)
    {
        desktop->click(window, {180, 168}); // the search box
        desktop->tap("a", "Control_L");
        type(text);
        ASSERT_TRUE(settle());
    }
    static constexpr int widget = 328; ///< y of it
    static constexpr ivec2 save{39, 252}, load{87, 252}, low{109, 196};
    static constexpr ivec2 beside{180, 500}; ///< where no help follows the mouse
};

TEST_F(ChangedSettings, by_switches_choices_and_sliders)
{
    struct Case {
        const char* text;
        std::vector<ivec2> clicks; ///< on its widget
        double at_least;           ///< mean change of the scene's picture
    };
    constexpr ivec2 on_off{163, widget}, choice{240, widget}, first{240, widget + 28}, middle{240, widget},
        end{320, widget};
    for (const Case& c :
         {Case{"normal_m", {on_off}, 0.02}, Case{"specular_m", {on_off}, 0.02}, Case{"ambient.i", {end}, 3},
          Case{"ao.me", {choice, first}, 0.3}, Case{"shadow.f", {choice, first}, 0.3}, Case{"softness", {end}, 0.1},
          Case{"sky.i", {end}, 0.3}, Case{"ev100", {middle - ivec2(20, 0)}, 10}, Case{"tonemap", {choice, first}, 3},
          Case{"wireframe", {on_off}, 3}}) {
        seek(c.text);
        const Image8 before = scene();
        EXPECT_GT(change([&] {
                      for (const ivec2 at : c.clicks) desktop->click(window, at);
                      desktop->move(window, beside);
                  }),
                  c.at_least)
            << c.text;
        desktop->tap("z", "Control_L");
        EXPECT_TRUE(settle());
        EXPECT_EQ(mean_difference(before, scene()), 0) << c.text;
    }
}

TEST_F(ChangedSettings, a_preset_is_saved_and_loaded_again)
{
    const Image8 start = scene();
    EXPECT_GT(change([] {
                  desktop->click(window, low);
                  desktop->move(window, beside);
              }),
              0.3);
    EXPECT_GT(change([] { desktop->tap("n"); }), 0.02);
    const Image8 kept = scene();
    desktop->click(window, save);
    desktop->move(window, beside);
    ASSERT_TRUE(settle());
    ASSERT_TRUE(fs::exists(folder / "settings.toml"));
    EXPECT_NE(bytes_of(folder / "settings.toml").find("normal_mapping = \"off\""), std::string::npos);
    EXPECT_GT(change([] {
                  desktop->tap("z", "Control_L");
                  desktop->tap("z", "Control_L");
              }),
              0.3);
    EXPECT_EQ(mean_difference(start, scene()), 0);
    EXPECT_GT(change([] {
                  desktop->click(window, load);
                  desktop->move(window, beside);
              }),
              0.3);
    EXPECT_EQ(mean_difference(kept, scene()), 0);
}

} // namespace
} // namespace atrium::window
