#pragma once
// What a window remembers from one run to the next: where it was, what it last looked at, what the user keeps.

#include "app/gui/bookmarks.hpp"
#include "app/view/window.hpp"
#include "renderer/scene/camera.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace atrium::app {

struct WindowState {
    WindowPlace place;
    std::filesystem::path scene; ///< absolute; empty: none yet
    Camera camera;               ///< in it
    std::string settings_file = "settings.toml";
    std::map<std::string, gui::Bookmarks> bookmarks; ///< by the absolute path of the scene
    std::vector<std::filesystem::path> recent;       ///< scenes, newest first
    bool operator==(const WindowState&) const = default;
};

/// $XDG_CONFIG_HOME/atrium/NAME, or below ~/.config; empty when neither variable is set.
[[nodiscard]] std::filesystem::path user_file(const std::string& name);

/// A fresh one where there is no such file. Throws Error where it is damaged, after it was renamed to NAME.damaged: it
/// must neither keep a window shut nor be written over when that closes.
[[nodiscard]] WindowState read_window_state(const std::filesystem::path& file);

/// Makes the folder. Tells when it cannot be written, and goes on.
void write_window_state(const std::filesystem::path& file, const WindowState& state);

} // namespace atrium::app
