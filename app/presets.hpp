#pragma once
// Named sets of settings, from assets/presets/*.toml, embedded in the program.

#include "renderer/scene/scene_file.hpp"

#include <string>
#include <vector>

namespace atrium::app {

/// Throws Error(usage) naming the nearest preset.
[[nodiscard]] std::vector<SettingText> preset_settings(const std::string& name);
[[nodiscard]] std::vector<std::string> preset_names();

} // namespace atrium::app
