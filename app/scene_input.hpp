#pragma once
// From the SCENE argument to what the engine draws: bakes, instances, lights, cameras, settings.

#include "app/options.hpp"
#include "renderer/engine.hpp"
#include "renderer/scene/bake_file.hpp"
#include "renderer/scene/scene_file.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace atrium::app {

/// A camera for a scene that has none.
struct FoundCamera {
    Camera camera;
    bool inside = false; ///< the scene; otherwise outside, with the whole scene in view
};

struct SceneInput {
    std::vector<std::unique_ptr<BakeFile>> bakes; ///< the first is the scene's own
    std::vector<Instance> instances;
    SceneFile file;                           ///< empty but for its bake when SCENE is no scene file
    FrameConfig config;                       ///< of --config
    std::vector<std::filesystem::path> files; ///< every file that was read: none of them may be an output
    std::optional<FoundCamera> found;         ///< if neither the options nor the scene have a camera
    [[nodiscard]] SceneDescription description() const;
};

/// Reads a bake, a scene file with the bakes it names, or bakes an OBJ into the cache first; and --config. Throws
/// Error(input).
[[nodiscard]] SceneInput read_scene_input(const SceneOptions& o, const FrameOptions& frame);

/// Texts of settings in order of precedence; applied once the device is known.
class SettingChain {
public:
    /// Weakest first: defaults, the device's preset, --preset, scene file, --config, --set.
    SettingChain(const FrameOptions& o, const SceneInput& scene);
    /// New settings with the chain applied; a `sky.floor` of `auto` is replaced by `on` if camera and light are the
    /// program's defaults. Throws Error naming the nearest key, or the range.
    [[nodiscard]] Settings apply(bool cpu_device) const;

private:
    struct Entry {
        SettingText text;
        ExitCode code;
    };
    std::vector<Entry> entries_;
    bool default_view_ = false; ///< the scene from outside, under the default sun
};

/// Lights in order: the scene file's (or those of the picture given as --config), then --light; a sun when there are
/// none and --no-lights was not given. Named.
[[nodiscard]] std::vector<Light> collect_lights(const FrameOptions& o, const SceneInput& scene);

/// --eye and --target, --camera, the picture's given as --config, the scene's first camera, or one found from the
/// geometry.
[[nodiscard]] Camera choose_camera(const FrameOptions& o, const SceneInput& scene);

/// A request with everything that the options and the scene say but the AOVs; settings still without a device's
/// defaults, to find mistakes before a device is touched.
[[nodiscard]] FrameRequest make_request(const FrameOptions& o, const SceneInput& scene, const SettingChain& chain);

/// The engine that the options ask for, with the program's cache.
[[nodiscard]] EngineOptions engine_options(const SceneOptions& o);

/// The exit code of a command that has drawn: 0. Throws Error(internal) where validation had something to say: one
/// message fails a run, whatever was drawn.
[[nodiscard]] int verdict(const Engine& engine);

/// By its ending.
[[nodiscard]] bool is_obj(const std::filesystem::path& scene);

/// The default camera, if none is given: inside if the middle of the scene is free and mostly enclosed, otherwise
/// outside with the whole scene in view. `--from` overrides the choice.
void find_camera(SceneInput& scene, const FrameOptions& o);
/// Logs a line if the default camera is inside the scene, with the option that places it outside.
void tell_camera(const SceneInput& scene, const FrameOptions& o);

/// --size, the picture's given as --config, or 1280x720.
[[nodiscard]] uvec2 picture_size(const FrameOptions& o, const SceneInput& scene);

} // namespace atrium::app
