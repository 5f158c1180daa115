#pragma once
// What a window remembers from one run to the next: where it was, what it last looked at, what the user keeps.

#include "app/gui/bookmarks.hpp"
#include "app/view/window.hpp"
#include "renderer/scene/camera.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace atrium::app {

struct WindowState {
    WindowPlace place;
    std::filesystem::path scene; ///< absolute; empty: none yet
    Camera camera;               ///< in it
    std::string settings_file = "settings.toml";
    std::map<std::string, gui::Bookmarks> bookmarks; ///< by the absolute path of the scene
    bool operator==(const WindowState&) const = default;
};

/// $XDG_CONFIG_HOME/atrium/NAME, or below ~/.config; empty when neither variable is set.
[[nodiscard]] std::filesystem::path user_file(const std::string& name);

/// None where there is no such file. A damaged one is told of and taken for none: it must not keep a window shut.
[[nodiscard]] std::optional<WindowState> read_window_state(const std::filesystem::path& file);

/// Makes the folder. Tells when it cannot be written, and goes on.
void write_window_state(const std::filesystem::path& file, const WindowState& state);

} // namespace atrium::app
