#include "app/gui/setting_step.hpp"

#include "app/view/key_bindings.hpp"
#include "app/view/key_names.hpp"
#include "renderer/core/atomic_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

namespace atrium::gui {
namespace {

enum class Finish { matt, satin, gloss };
constexpr auto enum_names(Finish)
{
    return std::array{"matt", "satin", "gloss"};
}

struct MadeUp {
    bool on = false;
    Finish finish = Finish::matt, two = Finish::satin;
    int count = 5;
    float width = 2, shift = 0, from_nothing = 0;
    std::string text = "none";
    vec3 place{0};
};

template <class V>
void describe(V& v, MadeUp& s)
{
    v.group("made", "Made up");
    v("on", s.on, "A switch", Keys{"F6"});
    v("finish", s.finish, "One of three");
    v("two", s.two, "One of three, two of which matter", Keys{"F3", "", "satin", "gloss"});
    v("count", s.count, "A count", Range{1, 6});
    v("width", s.width, "A width", Range{0, 2.5f}, "m", Keys{"F4", "Ctrl+F4"});
    v("shift", s.shift, "Either way", Range{-1, 1});
    v("from_nothing", s.from_nothing, "None at first", Range{0, 50});
    v("text", s.text, "A text");
    v("place", s.place, "A place");
}

struct setting_step : ::testing::Test {
    MadeUp made;
    SettingList list;
    setting_step() { describe(list, made); }
    void take(const std::string& name) const
    {
        const auto steps = setting_steps(list);
        const auto at = std::find_if(steps.begin(), steps.end(), [&](const SettingStep& s) { return s.name == name; });
        ASSERT_NE(at, steps.end()) << name;
        take_step(list, *at);
    }
};

TEST_F(setting_step, switches_and_choices_go_round)
{
    take("made.on");
    EXPECT_TRUE(made.on);
    take("made.on");
    EXPECT_FALSE(made.on);
    for (const Finish wanted : {Finish::satin, Finish::gloss, Finish::matt}) {
        take("made.finish");
        EXPECT_EQ(made.finish, wanted);
    }
    for (const Finish wanted : {Finish::gloss, Finish::satin, Finish::gloss}) {
        take("made.two");
        EXPECT_EQ(made.two, wanted);
    }
    made.two = Finish::matt; // neither of the two
    take("made.two");
    EXPECT_EQ(made.two, Finish::satin);
}

TEST_F(setting_step, numbers_stay_in_their_range_and_come_back)
{
    take("made.width.more");
    EXPECT_FLOAT_EQ(made.width, 2.2f);
    take("made.width.less");
    EXPECT_FLOAT_EQ(made.width, 2);
    for (int i = 0; i < 5; ++i) take("made.width.more");
    EXPECT_FLOAT_EQ(made.width, 2.5f);
    take("made.count.more");
    EXPECT_EQ(made.count, 6);
    take("made.count.more");
    EXPECT_EQ(made.count, 6);
    for (int i = 0; i < 9; ++i) take("made.count.less");
    EXPECT_EQ(made.count, 1);
    take("made.shift.less");
    EXPECT_FLOAT_EQ(made.shift, -0.1f);
    take("made.shift.more");
    EXPECT_NEAR(made.shift, 0, 1e-6f);
    take("made.from_nothing.less");
    EXPECT_EQ(made.from_nothing, 0);
    take("made.from_nothing.more");
    EXPECT_FLOAT_EQ(made.from_nothing, 0.5f);
}

TEST_F(setting_step, what_is_described_has_a_key_a_line_of_help_and_one_of_documentation)
{
    const app::KeyBindings keys(list);
    const auto step = [&](const char* key) { return keys.step_of(*app::parse_key(key)); };
    ASSERT_NE(step("F6"), nullptr);
    EXPECT_EQ(step("F6")->setting, "made.on");
    EXPECT_EQ(step("F3")->setting, "made.two");
    EXPECT_FALSE(step("F4")->less);
    EXPECT_TRUE(step("Ctrl+F4")->less);
    std::size_t lines = 0;
    for (const KeyHelp& line : keys.help()) lines += line.name.starts_with("made.") ? 1 : 0;
    EXPECT_EQ(lines, 4u);
    EXPECT_NE(list.to_markdown().find("| A width | F4, Ctrl+F4 |"), std::string::npos);
}

TEST_F(setting_step, any_setting_can_have_a_key_and_only_numbers_have_two)
{
    const auto file = std::filesystem::temp_directory_path() / ("steps-" + std::to_string(getpid()) + ".toml");
    write_text_file(file, "made.finish = 'K'\n[made.count]\nless = 'J'\n[made.width]\nmore = 'F6'\n");
    app::KeyBindings keys(list);
    const std::vector<Error> errors = keys.read(file);
    std::filesystem::remove(file);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_NE(errors[0].why().find("made.on"), std::string::npos); // has F6
    EXPECT_EQ(keys.step_of(*app::parse_key("K"))->name, "made.finish");
    EXPECT_EQ(keys.step_of(*app::parse_key("J"))->name, "made.count.less");
    for (const SettingStep& step : setting_steps(list)) EXPECT_FALSE(step.name.starts_with("made.text")) << step.name;
    EXPECT_EQ(setting_steps(list).size(), 3u + 2u * 4u);
}

} // namespace
} // namespace atrium::gui
