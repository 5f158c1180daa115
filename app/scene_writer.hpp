#pragma once
// Scene files written, as renderer/scene/scene_file.hpp reads them.

#include "renderer/scene/scene_file.hpp"

#include <filesystem>
#include <string>

namespace atrium::app {

/// The scene as a file that stands in `folder`: bakes below it are named relative to it, others by their whole path.
[[nodiscard]] std::string scene_toml(const SceneFile& scene, const std::filesystem::path& folder);

/// Throws Error(environment), or Error(usage) where the file is one of the bakes that the scene names.
void write_scene_file(const std::filesystem::path& file, const SceneFile& scene);

/// Every setting that some device would not have by default, so that the file means the same on all of them.
[[nodiscard]] std::vector<SettingText> portable_settings(const SettingList& list);

} // namespace atrium::app
