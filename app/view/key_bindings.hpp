#pragma once
// Which key does what: by default, and as a file says.

#include "app/gui/panels.hpp"
#include "app/view/actions.hpp"
#include "renderer/core/error.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace atrium::app {

class KeyBindings {
public:
    KeyBindings(); ///< every action on its default key

    /// Binds what a TOML file says, in lines such as `undo = "Ctrl+U"`. What it says wrongly is returned, one
    /// Error(input) each, and the actions of those lines have their default keys.
    [[nodiscard]] std::vector<Error> read(const std::filesystem::path& file);

    /// What a key does that went down; Action::none is the answer for keys that are held, too.
    [[nodiscard]] Action action_of(const KeyPress& press) const;
    [[nodiscard]] KeyPress key_of(Action action) const;

    /// For the help panel: keys and what they do, the mouse included.
    [[nodiscard]] std::vector<gui::KeyHelp> help() const;

private:
    struct Line {
        std::size_t action = 0;
        KeyPress key;
        std::string where;
    };
    void bind(const std::vector<Line>& lines);
    [[nodiscard]] std::optional<std::size_t> other_on_same_key(std::size_t action) const;

    std::vector<KeyPress> keys_; ///< in the order of all_actions(), as all indices of actions here
};

} // namespace atrium::app
