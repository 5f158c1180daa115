#include "app/view/scene_opener.hpp"

#include "app/stats.hpp"
#include "app/view/scene_facts.hpp"
#include "renderer/core/error.hpp"

#include <fmt/format.h>

#include <chrono>
#include <stdexcept>
#include <system_error>

namespace atrium::app {

SceneOpener::SceneOpener(Engine& engine, const SceneOptions& options, const FrameOptions& frame, SceneInput scene)
    : engine_(engine), options_(options), scene_(std::move(scene))
{
    frame_.size = frame.size;
    frame_.fov = frame.fov;
    frame_.from = frame.from;
    frame_.set = frame.set;
    frame_.preset = frame.preset;
    frame_.config = frame.config;
}

void SceneOpener::open(const std::filesystem::path& file)
{
    std::error_code unknown; // is told when it is read
    if (std::filesystem::is_directory(file, unknown)) {
        throw Error(ExitCode::input, "a folder is not a scene", file.string(), "one file is opened at a time",
                    "give a bake (.atrium), a scene file (.toml) or an OBJ in it");
    }
    cancel();
    Opening& opening = opening_.emplace();
    opening.file = file;
    looks_ = 0;
    try {
        if (is_obj(file)) opening.bake.emplace(file, options_.bake_scale, options_.bake_up, ObjBake::Output::kept);
    } catch (...) {
        cancel();
        throw;
    }
}

std::string SceneOpener::progress() const
{
    if (!opening_) return "";
    const std::string name = opening_->file.filename().string();
    if (!opening_->bake) return fmt::format("Opening {}", name);
    const std::string said = opening_->bake->progress();
    return fmt::format("Baking {}\n{}", name, said.empty() ? "reading the OBJ" : said);
}

bool SceneOpener::ready()
{
    constexpr int looks_of_a_note = 3; // its window is laid out in one frame and seen in the next
    std::optional<ObjBake>& bake = opening_->bake;
    if (bake && !bake->done()) return false;
    if (bake) opening_->baked = bake->bake();
    bake.reset();
    return ++looks_ > looks_of_a_note;
}

std::optional<SceneStart> SceneOpener::update()
{
    if (!opening_) return std::nullopt;
    try {
        if (!ready()) return std::nullopt;
        SceneStart start = load(*opening_);
        cancel();
        return start;
    } catch (...) {
        cancel();
        throw;
    }
}

void SceneOpener::go_back()
{
    try {
        engine_.load(scene_.description());
    } catch (const Error& error) { // nothing is left to be shown
        throw std::runtime_error(error.text());
    }
}

SceneStart SceneOpener::load(const Opening& opening)
{
    const auto from = std::chrono::steady_clock::now();
    SceneOptions options = options_;
    options.scene = opening.baked.value_or(opening.file);
    SceneInput scene = read_scene_input(options, frame_);
    scene.config.camera.reset();
    scene.config.lights.reset();
    scene.config.materials.clear();
    find_camera(scene, frame_);
    tell_camera(scene, frame_);
    const SettingChain chain(frame_, scene);
    FrameRequest frame = make_request(frame_, scene, chain);
    frame.settings = chain.apply(engine_.device().report().is_cpu);
    const SceneDescription description = scene.description();
    try {
        engine_.load(description);
    } catch (const Error&) { // such as one too large for the device
        go_back();
        throw;
    }
    gui::SceneFacts facts = gather_facts(description, engine_.scene(), ms_since(from));
    scene_ = std::move(scene);
    return {scene_path(opening.file), std::move(frame), scene_.file, std::move(facts)};
}

} // namespace atrium::app
