#include "app/view/key_bindings.hpp"

#include "app/view/key_names.hpp"
#include "renderer/core/atomic_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <set>
#include <string>

namespace atrium::app {
namespace {

/// What is on the keys after a file has been read, and what the file has wrong.
struct Bound {
    explicit Bound(const std::string& text)
        : file(std::filesystem::temp_directory_path() / ("keys-" + std::to_string(getpid()) + ".toml"))
    {
        write_text_file(file, text);
        errors = keys.read(file);
        std::filesystem::remove(file);
    }
    [[nodiscard]] Action on(const char* key) const { return keys.action_of(*parse_key(key)); }
    [[nodiscard]] std::string step_on(const char* key) const
    {
        const gui::SettingStep* step = keys.step_of(*parse_key(key));
        return step == nullptr ? "" : step->name;
    }
    [[nodiscard]] std::string where(int line) const { return file.string() + ":" + std::to_string(line); }
    std::filesystem::path file;
    KeyBindings keys;
    std::vector<Error> errors;
};

TEST(key_names, are_read_as_they_are_written)
{
    std::set<std::string> seen;
    for (const std::string& name : key_names()) {
        EXPECT_TRUE(seen.insert(name).second) << name;
        for (const char* modifiers : {"", "Ctrl+", "Alt+", "Ctrl+Alt+"}) {
            const auto key = parse_key(modifiers + name);
            ASSERT_TRUE(key.has_value()) << name;
            EXPECT_EQ(name_of(*key), modifiers + name);
        }
    }
    EXPECT_EQ(parse_key("ctrl+page UP"), parse_key("Ctrl+Page up"));
    for (const char* none : {"", "Ctrl+", "Hyper", "AA", "F13"}) EXPECT_FALSE(parse_key(none).has_value()) << none;
}

TEST(key_bindings, defaults_have_a_key_each_and_the_help_lists_them)
{
    const KeyBindings keys;
    std::set<std::string> seen;
    for (const ActionInfo& info : all_actions()) {
        EXPECT_EQ(keys.step_of(info.key), nullptr);
        EXPECT_TRUE(seen.insert(name_of(keys.key_of(info.action))).second) << info.name;
        EXPECT_EQ(keys.action_of(info.key), is_held(info.action) ? Action::none : info.action) << info.name;
    }
    std::size_t named = 0;
    for (const gui::KeyHelp& line : keys.help()) {
        named += line.name.empty() ? 0 : 1;
        EXPECT_TRUE(line.name.empty() || seen.insert(line.keys).second ||
                    keys.step_of(*parse_key(line.keys)) == nullptr)
            << line.keys << " has two acts";
    }
    EXPECT_EQ(named, all_actions().size() + 5); // of settings: P, Page up, Page down, O, N
}

TEST(key_bindings, a_file_changes_them)
{
    const Bound bound("ao.method = 'P'\nshadow.filter = 'o'\nundo = 'Alt+Backspace'\nforward = 'Up'\nturn_up = 'W'\n");
    EXPECT_TRUE(bound.errors.empty());
    EXPECT_EQ(bound.step_on("P"), "ao.method");
    EXPECT_EQ(bound.step_on("O"), "shadow.filter");
    EXPECT_EQ(bound.on("Alt+Backspace"), Action::undo);
    EXPECT_EQ(bound.on("Ctrl+Z"), Action::none);
    EXPECT_EQ(bound.on("Ctrl+Y"), Action::redo);
    EXPECT_EQ(name_of(bound.keys.key_of(Action::forward)), "Up");
}

TEST(key_bindings, mistakes_are_told_with_their_line_and_the_rest_counts)
{
    const Bound bound("screnshot = 'F2'\ngui = 'Hoem'\nhelp = 3\nup = 'Ctrl+E'\nundo = 'U'\n");
    ASSERT_EQ(bound.errors.size(), 4u);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(bound.errors[static_cast<std::size_t>(i)].where(), bound.where(i + 1));
    EXPECT_NE(bound.errors[0].why().find("\"screenshot\""), std::string::npos);
    EXPECT_NE(bound.errors[1].why().find("\"Home\""), std::string::npos);
    EXPECT_EQ(bound.on("F12"), Action::screenshot);
    EXPECT_EQ(bound.on("F1"), Action::gui);
    EXPECT_EQ(bound.on("H"), Action::help);
    EXPECT_EQ(bound.on("U"), Action::undo);
}

TEST(key_bindings, of_two_actions_on_a_key_the_later_line_does_not_count)
{
    const Bound bound("gui = 'K'\nhelp = 'K'\nframe = 'V'\n");
    ASSERT_EQ(bound.errors.size(), 2u);
    EXPECT_EQ(bound.errors[0].where(), bound.where(3)); // V has another action by default
    EXPECT_EQ(bound.errors[1].where(), bound.where(2));
    EXPECT_EQ(bound.on("K"), Action::gui);
    EXPECT_EQ(bound.on("H"), Action::help);
    EXPECT_EQ(bound.on("Home"), Action::frame);
    EXPECT_EQ(bound.on("V"), Action::compare);
}

TEST(key_bindings, a_default_that_an_action_goes_back_to_may_be_taken_in_turn)
{
    const Bound bound("gui = 'H'\nhelp = 'V'\n"); // V is taken, so help stays on H, and gui on F1
    ASSERT_EQ(bound.errors.size(), 2u);
    EXPECT_EQ(bound.on("H"), Action::help);
    EXPECT_EQ(bound.on("F1"), Action::gui);
    EXPECT_EQ(bound.on("V"), Action::compare);
}

TEST(key_bindings, what_is_no_toml_changes_nothing)
{
    const Bound bound("gui = 'K'\nhelp = \n");
    ASSERT_EQ(bound.errors.size(), 1u);
    EXPECT_EQ(bound.errors[0].where(), bound.where(2));
    EXPECT_EQ(bound.on("F1"), Action::gui);
}

} // namespace
} // namespace atrium::app
