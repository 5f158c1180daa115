#pragma once
// Camera paths that are edited and played in the window.

#include "renderer/scene/camera_path.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace atrium::gui {

/// Adds a path whose first key, at 0 s, is the camera. An empty name gets a free one, which is written into `name`. The
/// answer is what is wrong with the name, and then nothing is changed.
[[nodiscard]] std::optional<std::string> add_path(CameraPaths& paths, std::string& name, const Camera& camera);

/// Adds a key at its place in time, which is the answer; none where another key has this time.
[[nodiscard]] std::optional<std::size_t> add_key(CameraPath& path, float time, const Camera& camera);

/// Moves eye and target to a key.
void go_to(Camera& camera, const CameraKey& key);

/// One path, played or scrubbed.
struct PathPlayer {
    float time = 0; ///< s
    bool playing = false;

    /// From where it stands, or from the start where that is the end.
    void play(const CameraPath& path);
    /// The time after so many seconds, and the camera of it; stands still at the end. Whether it was playing.
    bool advance(const CameraPath& path, double seconds, Camera& camera);
};

} // namespace atrium::gui
