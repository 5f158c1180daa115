#pragma once
// Scene files: TOML that names a bake, settings, cameras, lights, instances, material overrides and camera paths.

#include "renderer/scene/camera.hpp"
#include "renderer/scene/camera_path.hpp"
#include "renderer/scene/light.hpp"
#include "renderer/scene/material_override.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace atrium {

/// A value of [settings] as text, with the place it stood at for error messages.
struct SettingText {
    std::string key, value, where; ///< where: "file:line"
};

struct InstanceEntry {
    std::filesystem::path bake; ///< resolved against the scene file's folder; the scene's own when none is given
    std::string mesh;           ///< one mesh of it; empty: all
    vec3 position{0};
    vec3 rotation{0}; ///< degrees about x, y, z, applied in that order
    float scale = 1;
};

struct SceneFile {
    std::filesystem::path path, bake;
    std::vector<SettingText> settings;
    std::vector<std::pair<std::string, Camera>> cameras; ///< in file order; the first is the default
    std::vector<Light> lights;                           ///< in file order, not yet named by index
    std::vector<InstanceEntry> instances;
    std::vector<MaterialOverride> materials;
    CameraPaths paths;
};

/// Throws Error(input) with file:line on bad TOML, wrong types, unknown keys (with the nearest valid name).
[[nodiscard]] SceneFile read_scene_file(const std::filesystem::path& file);

/// What a picture says about itself: all that is needed to draw it again, but the scene.
struct FrameConfig {
    std::vector<SettingText> settings;
    std::optional<Camera> camera;
    std::optional<std::vector<Light>> lights;
    std::optional<uvec2> size;
    std::optional<double> time;
    std::vector<MaterialOverride> materials; ///< after those of the scene file
};
/// Reads TOML with the keys width, height, time, lights = [SPEC…], [camera], [settings] and [[material]]; throws
/// Error(input).
[[nodiscard]] FrameConfig parse_frame_config(std::string_view text, const std::filesystem::path& file);

/// A file for --config: settings, in its [settings] table or at top level, and [[material]] tables. Throws as above.
[[nodiscard]] FrameConfig read_settings_file(const std::filesystem::path& file);
/// The settings alone, from memory; `file` names it in messages.
[[nodiscard]] std::vector<SettingText> parse_settings(std::string_view text, const std::filesystem::path& file);

} // namespace atrium
