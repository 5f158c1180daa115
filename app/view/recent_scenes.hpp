#pragma once
// The scenes that were opened last.

#include <filesystem>
#include <vector>

namespace atrium::app {

/// The path under which a scene is remembered: absolute, without detours.
[[nodiscard]] std::filesystem::path scene_path(const std::filesystem::path& file);

/// Puts a scene before all others of the list, in which it then stands once; the oldest beyond ten go.
void remember_scene(std::vector<std::filesystem::path>& recent, const std::filesystem::path& scene);

} // namespace atrium::app
