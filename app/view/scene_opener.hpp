#pragma once
// Other scenes in the place of the one that the window shows.

#include "app/gui/scene_facts.hpp"
#include "app/obj_bake.hpp"
#include "app/scene_input.hpp"
#include "app/view/recent_scenes.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace atrium::app {

/// How to begin with a scene.
struct SceneStart {
    std::filesystem::path file; ///< as scene_path() says it
    FrameRequest frame;
    SceneFile scene_file;
    gui::SceneFacts facts; ///< of what the engine has
};

class SceneOpener {
public:
    /// After the engine was given `scene`, which the command line named. Of its options those about settings and the
    /// device hold for other scenes too; cameras, lights and materials are each scene's own.
    SceneOpener(Engine& engine, const SceneOptions& options, const FrameOptions& frame, SceneInput scene);

    /// Begins to open a bake, a scene file or an OBJ, which is baked first, beside the window. Whatever was on its way
    /// is given up. Throws Error.
    void open(const std::filesystem::path& file);
    void cancel() { opening_.reset(); }
    [[nodiscard]] bool busy() const { return opening_.has_value(); }
    /// Whether that still takes a while, and can be cancelled meanwhile.
    [[nodiscard]] bool baking() const { return opening_ && opening_->bake; }
    /// What is on its way, for who waits; empty where nothing is.
    [[nodiscard]] std::string progress() const;

    /// To be called between two frames: puts the scene into the engine once it can. Throws Error where it cannot be
    /// shown; the engine then has the scene of before, whose textures may stand elsewhere: find_images(). Any other
    /// exception: it has none.
    [[nodiscard]] std::optional<SceneStart> update();

private:
    struct Opening {
        std::filesystem::path file;
        std::optional<ObjBake> bake;                ///< until it is done
        std::optional<std::filesystem::path> baked; ///< then
    };
    [[nodiscard]] bool ready();
    [[nodiscard]] SceneStart load(const Opening& opening);
    /// To the scene of before. Throws std::runtime_error.
    void go_back();

    Engine& engine_;
    SceneOptions options_;
    FrameOptions frame_;
    SceneInput scene_; ///< kept to go back to
    std::optional<Opening> opening_;
    int looks_ = 0; ///< calls of update() since nothing of it is being baked
};

} // namespace atrium::app
