#pragma once
// Which key does what: by default, and as a file says.

#include "app/gui/panels.hpp"
#include "app/gui/setting_step.hpp"
#include "app/view/actions.hpp"
#include "renderer/core/error.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace atrium::app {

class KeyBindings {
public:
    /// Every action and every step of the settings on its default key; most steps have none.
    explicit KeyBindings(const SettingList& settings);
    KeyBindings(); ///< with those of the program

    /// Binds what a TOML file says, in lines such as `undo = "Ctrl+U"` or `ao.method = "K"`. What it says wrongly is
    /// returned, one Error(input) each, and the actions of those lines have their default keys.
    [[nodiscard]] std::vector<Error> read(const std::filesystem::path& file);

    /// What a key does that went down; Action::none is the answer for keys that are held, too.
    [[nodiscard]] Action action_of(const KeyPress& press) const;
    /// The step of a setting that it makes; null where it makes none.
    [[nodiscard]] const gui::SettingStep* step_of(const KeyPress& press) const;
    [[nodiscard]] KeyPress key_of(Action action) const;

    /// For the help panel: keys and what they do, the mouse included. What has no key is left out.
    [[nodiscard]] std::vector<gui::KeyHelp> help() const;

private:
    /// Something that can have a key: an action, or with Action::none a step.
    struct Bindable {
        std::string name, help;
        KeyPress by_default, key; ///< none: {0, 0}
        Action action = Action::none;
        gui::SettingStep step;
    };
    struct Line {
        std::size_t index = 0; ///< of what it binds
        KeyPress key;
        std::string where;
    };
    [[nodiscard]] std::size_t find(const std::string& name, const std::string& where) const;
    [[nodiscard]] const Bindable* bound_to(const KeyPress& press) const;
    void bind(const std::vector<Line>& lines);
    [[nodiscard]] std::optional<std::size_t> other_on_same_key(std::size_t index) const;

    std::vector<Bindable> all_;
};

} // namespace atrium::app
