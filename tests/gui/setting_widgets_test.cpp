#include "app/gui/setting_widgets.hpp"

#include "app/gui/view_model.hpp"
#include "tests/gui/headless.hpp"

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <array>
#include <set>
#include <string>

namespace atrium::gui {
namespace {

using test::HeadlessGui;

enum class Shape { round, square };
constexpr auto enum_names(Shape)
{
    return std::array{"round", "square"};
}

/// One of every type, with and without range and unit.
struct MadeUp {
    bool on = true;
    int count = 3, free_count = 5;
    float length = 2, tiny = 0.01f, amount = 10, free_number = 0;
    vec3 base_color{1, 0.5f, 0}, radiance{100, 3, 0}, place{1, 2, 3}, free_vector{0};
    Shape shape = Shape::square;
    std::string text = "plain";
    float a_name_so_long_that_it_wants_a_line_of_its_own = 1;
};

template <class V>
void describe(V& v, MadeUp& s)
{
    v.group("made", "Made up");
    v("on", s.on, "A switch");
    v("count", s.count, "Counts", Range{1, 1e10f}, "100% things of a very long unit indeed", Cpu{4});
    v("free_count", s.free_count, "Counts without end");
    v("length", s.length, "Of something", Range{0, 10}, "m");
    v("tiny", s.tiny, "Small to large", Range{1e-4f, 1e4f}, "m", Cpu{0.5f});
    v("amount", s.amount, "Up to very much", Range{0, 1e9f}, "%");
    v("free_number", s.free_number, "Any");
    v.group("more", "More of it");
    v("base_color", s.base_color, "A colour", Range{0, 1});
    v("radiance", s.radiance, "Of light", Range{0, 1000}, "nit-like");
    v("place", s.place, "Where it is", Range{-1e6f, 1e6f}, "m");
    v("free_vector", s.free_vector, "Anything");
    v("shape", s.shape, "Which shape");
    v("text", s.text, "Some text");
    v("a_name_so_long_that_it_wants_a_line_of_its_own", s.a_name_so_long_that_it_wants_a_line_of_its_own, "Long");
}

struct Fixture : ::testing::Test {
    HeadlessGui gui{360, 600};
    MadeUp made;
    SettingList list;
    ImVec2 from, to; ///< of the last line drawn
    Fixture() { describe(list, made); }

    /// One setting alone in a window, and where it came to lie.
    std::function<void()> only(const char* key)
    {
        return [this, key] {
            changed = draw_setting(*list.find(key), false) || changed;
            from = {10, 10};
            to = ImGui::GetItemRectMax();
        };
    }
    bool changed = false;
};
using setting_widgets = Fixture;

TEST(setting_widgets_of_atrium, every_setting_has_one)
{
    const HeadlessGui gui(800, 600);
    ViewModel model;
    DrawnSettings drawn;
    for (int frame = 0; frame < 3; ++frame) {
        gui.frame([&] { drawn = draw_settings(model.list, "", false, Headings::open); });
        EXPECT_EQ(drawn.count, static_cast<int>(model.list.all().size()));
        EXPECT_FALSE(drawn.changed);
    }
    EXPECT_GT(drawn.count, 40);
    EXPECT_EQ(gui.cut_off(), std::vector<std::string>{});
    EXPECT_TRUE(model.list.differing().empty());

    gui.frame([&] { drawn = draw_settings(model.list, "", false, Headings::close); });
    EXPECT_EQ(drawn.count, 0);
}

TEST(setting_widgets_of_atrium, radiance_is_edited_as_a_colour)
{
    ViewModel model;
    for (const char* key : {"ambient.sky", "ambient.ground", "sky.zenith", "sky.horizon", "sky.ground"}) {
        ASSERT_NE(model.list.find(key), nullptr) << key;
        EXPECT_TRUE(is_color(*model.list.find(key))) << key;
    }
    EXPECT_FALSE(is_color(*model.list.find("ambient.intensity")));
}

TEST_F(setting_widgets, settings_of_every_type_are_drawn_by_their_description)
{
    std::set<std::string> types;
    for (const Setting& s : list.all()) types.insert(s.type());
    EXPECT_EQ(types.size(), std::variant_size_v<decltype(Setting::field)>); // none is missing here
    const auto before = list.to_toml();
    for (const bool is_cpu : {false, true}) {
        DrawnSettings drawn;
        for (int frame = 0; frame < 2; ++frame) {
            gui.frame([&] { drawn = draw_settings(list, "", is_cpu, Headings::open); });
        }
        EXPECT_EQ(drawn.count, static_cast<int>(list.all().size()));
        EXPECT_FALSE(drawn.changed);
        EXPECT_EQ(gui.cut_off(), std::vector<std::string>{});
    }
    EXPECT_EQ(list.to_toml(), before); // looking changes nothing
}

TEST_F(setting_widgets, values_at_and_beyond_their_ends_stay_as_they_are)
{
    made.count = 1;
    made.amount = 0;
    made.tiny = 1e4f;
    made.place = {-1e6f, 1e6f, 0};
    made.length = 11; // out of its range: another's doing, and shown all the same
    const auto before = list.to_toml();
    for (int frame = 0; frame < 3; ++frame) gui.frame([&] { draw_settings(list, "", false, Headings::open); });
    EXPECT_EQ(list.to_toml(), before);
}

TEST_F(setting_widgets, a_click_turns_a_switch_and_the_arrow_turns_it_back)
{
    gui.frame(only("made.on"));
    const float y = 0.5f * (from.y + to.y);
    gui.click(10 + 0.44f * 310 + 12, y, only("made.on"));
    EXPECT_FALSE(made.on);
    EXPECT_TRUE(changed);
    gui.frame(only("made.on"));
    gui.click(360 - 10 - 10, y, only("made.on"));
    EXPECT_TRUE(made.on);
}

TEST_F(setting_widgets, the_arrow_goes_back_to_the_device_s_default)
{
    const auto draw = [&] { draw_setting(*list.find("made.tiny"), true); };
    gui.frame(draw);
    gui.click(340, 22, draw);
    EXPECT_EQ(made.tiny, 0.5f); // the default of a CPU device, from which 0.01 differs
}

TEST_F(setting_widgets, a_slider_goes_from_one_end_of_the_range_to_the_other)
{
    const auto draw = only("made.length");
    gui.frame(draw);
    gui.mouse(250, 22, true);
    gui.frame(draw);
    gui.mouse(5000, 22, true);
    gui.frame(draw);
    EXPECT_EQ(made.length, 10.0f);
    gui.mouse(-5000, 22, true);
    gui.frame(draw);
    EXPECT_EQ(made.length, 0.0f);
}

/// Ctrl and a click turn a slider into a field.
void type_into_slider(const HeadlessGui& gui, const std::function<void()>& draw, const char* text)
{
    ImGuiIO& io = ImGui::GetIO();
    io.KeyMap[ImGuiKey_Enter] = 257;
    gui.frame(draw);
    io.KeyCtrl = true;
    io.KeyMods = ImGuiKeyModFlags_Ctrl;
    gui.click(250, 22, draw);
    io.KeyCtrl = false;
    io.KeyMods = ImGuiKeyModFlags_None;
    gui.type(text);
    gui.frame(draw);
    io.KeysDown[257] = true;
    gui.frame(draw);
    io.KeysDown[257] = false;
    gui.frame(draw);
}

TEST_F(setting_widgets, a_long_label_has_a_line_of_its_own)
{
    gui.frame(only("made.length"));
    const float one_line = to.y - from.y;
    gui.frame(only("more.a_name_so_long_that_it_wants_a_line_of_its_own"));
    EXPECT_GT(to.y - from.y, 1.9f * one_line);
}

TEST_F(setting_widgets, what_is_typed_is_brought_into_the_range)
{
    type_into_slider(gui, only("made.length"), "7.12345");
    EXPECT_EQ(made.length, 7.12345f);
    type_into_slider(gui, only("made.length"), "1234");
    EXPECT_EQ(made.length, 10.0f);
    type_into_slider(gui, only("made.length"), "-3");
    EXPECT_EQ(made.length, 0.0f);
    type_into_slider(gui, only("made.length"), "nan");
    EXPECT_EQ(made.length, 0.0f);
}

TEST_F(setting_widgets, a_text_counts_once_it_is_left)
{
    const auto both = [&] { // a click on the switch above takes the keyboard away before the field is drawn
        draw_setting(*list.find("made.on"), false);
        draw_setting(*list.find("more.text"), false);
    };
    gui.frame(both);
    gui.click(250, 52, both);
    gui.type("er");
    gui.frame(both);
    gui.frame(both);
    EXPECT_EQ(made.text, "plain");
    gui.click(160, 22, both);
    EXPECT_FALSE(made.on);
    EXPECT_NE(made.text, "plain");
    EXPECT_NE(made.text.find("er"), std::string::npos);
}

TEST_F(setting_widgets, escape_leaves_a_text_as_it_was)
{
    const auto draw = only("more.text");
    ImGuiIO& io = ImGui::GetIO();
    io.KeyMap[ImGuiKey_Escape] = 256;
    io.KeyMap[ImGuiKey_Enter] = 257;
    for (const int key : {256, 257}) {
        gui.frame(draw);
        gui.click(250, 22, draw);
        gui.type("er");
        gui.frame(draw);
        io.KeysDown[key] = true;
        gui.frame(draw);
        io.KeysDown[key] = false;
        gui.frame(draw);
        EXPECT_EQ(made.text == "plain", key == 256) << made.text;
    }
}

TEST_F(setting_widgets, a_drag_is_one_step_to_undo)
{
    ViewModel model;
    const auto draw = [&] {
        draw_setting(*model.list.find("ao.radius"), false);
        if (!ImGui::IsAnyItemActive()) model.checkpoint();
    };
    gui.frame(draw);
    const float start = model.settings.ao.radius;
    for (int i = 0; i < 20; ++i) {
        gui.mouse(200 + 5.0f * static_cast<float>(i), 22, true);
        gui.frame(draw);
    }
    gui.mouse(300, 22, false);
    gui.frame(draw);
    gui.frame(draw);
    EXPECT_GT(model.settings.ao.radius, start);
    ASSERT_TRUE(model.can_undo());
    model.undo();
    EXPECT_EQ(model.settings.ao.radius, start);
    EXPECT_FALSE(model.can_undo());
}

TEST_F(setting_widgets, filters_by_key_heading_and_help)
{
    const Setting& s = *list.find("more.base_color");
    for (const char* match :
         {"", "  ", "base", "BASE col", "base_color", "base color", "more of", "colour", "colour a"})
        EXPECT_TRUE(matches_filter(s, match)) << match;
    for (const char* other : {"place", "base place"}) EXPECT_FALSE(matches_filter(s, other)) << other;

    DrawnSettings drawn;
    gui.frame([&] { drawn = draw_settings(list, "without", false, Headings::close); });
    EXPECT_EQ(drawn.count, 1); // found in the help of free_count, and shown without a click
    gui.frame([&] { drawn = draw_settings(list, "nothing is called so", false); });
    EXPECT_EQ(drawn.count, 0);
}

TEST_F(setting_widgets, labels_tooltips_and_scales_come_from_the_description)
{
    EXPECT_EQ(label_of(*list.find("more.base_color")), "base color");
    EXPECT_EQ(tooltip_of(*list.find("made.length"), false), "Of something\nmade.length\nfrom 0 to 10 m\ndefault 2 m");
    EXPECT_EQ(tooltip_of(*list.find("made.tiny"), true),
              "Small to large\nmade.tiny\nfrom 0.0001 to 10000 m\ndefault 0.5 m");
    EXPECT_EQ(tooltip_of(*list.find("more.shape"), false),
              "Which shape\nmore.shape\none of round, square\ndefault square");
    EXPECT_TRUE(is_color(*list.find("more.base_color")));
    EXPECT_TRUE(is_color(*list.find("more.radiance")));
    EXPECT_FALSE(is_color(*list.find("more.place")));
    EXPECT_TRUE(is_logarithmic({1e-4f, 1e4f}));
    EXPECT_TRUE(is_logarithmic({0, 1e9f}));
    EXPECT_FALSE(is_logarithmic({64, 4096}));
    EXPECT_FALSE(is_logarithmic({-24, 24}));
    EXPECT_FALSE(is_logarithmic({0, 1}));
}

} // namespace
} // namespace atrium::gui
