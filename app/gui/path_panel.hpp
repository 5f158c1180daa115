#pragma once
// The part of the camera's tab that edits paths and saves the scene.

#include "app/gui/camera_paths.hpp"
#include "app/gui/view_model.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace atrium::gui {

/// What it remembers between frames.
struct PathPanel {
    std::string new_name;                 ///< that is being typed
    std::optional<std::size_t> path, key; ///< selected of the model's paths, and of that one's keys
    float new_time = 1;                   ///< s, of the next key
    PathPlayer player;
    std::string file = "scene.toml"; ///< to save the scene into
};

/// Draws it, and the selected path over the picture. `message` becomes what was refused or done.
void draw_paths(ViewModel& model, PathPanel& panel, std::string& message, float scale);

/// The model's camera goes on along the path that is playing. Whether there is one.
bool play_path(ViewModel& model, PathPanel& panel, double seconds);

} // namespace atrium::gui
