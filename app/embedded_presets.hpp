#pragma once
// assets/presets/*.toml as CMake embedded them.

#include <span>
#include <string_view>
#include <utility>

namespace atrium::app {

/// Name (the file's stem) and text of each preset.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> embedded_presets();

} // namespace atrium::app
