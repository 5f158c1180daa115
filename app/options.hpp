#pragma once
// The options that `render`, `bench` and `view` share, as typed.

#include "renderer/core/math.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace atrium::app {

struct SceneOptions {
    std::filesystem::path scene;
    std::string device;
    bool validate = false;
    double bake_scale = 1;
    std::string bake_up = "y";
};

/// Place of the default camera.
enum class CameraFrom { anywhere, outside, inside };

struct FrameOptions {
    std::optional<uvec2> size; ///< 1280x720 when not given
    std::string camera;
    std::optional<vec3> eye, target;
    std::optional<float> fov;
    CameraFrom from = CameraFrom::anywhere;
    std::vector<std::string> lights;
    bool no_lights = false;
    std::vector<std::string> set; ///< "key=value"
    std::string preset;
    std::filesystem::path config;
    std::optional<double> time;
};

void add_device_options(CLI::App& command, SceneOptions& o); ///< a part of the scene options
void add_scene_options(CLI::App& command, SceneOptions& o);
CLI::Option* add_size_option(CLI::App& command, std::optional<uvec2>& size, const std::string& help);
void add_frame_options(CLI::App& command, FrameOptions& o);

/// Parses the command line; throws Error(usage) that names the nearest option, or returns an exit code when --help or
/// --version has been answered.
[[nodiscard]] std::optional<int> parse_command_line(CLI::App& app, int argc, const char* const* argv);

} // namespace atrium::app
