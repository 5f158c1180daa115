// `atrium view`: the window.

#include "app/child_process.hpp"
#include "app/commands.hpp"
#include "app/scene_input.hpp"
#include "app/stats.hpp"
#include "app/view/scene_facts.hpp"
#include "app/view/viewer.hpp"
#include "app/view/window_state.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/log.hpp"
#include "shaders/sources.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <utility>

namespace atrium::app {
namespace {

struct Options {
    SceneOptions scene;
    FrameOptions frame;
    bool continuous = false;
    std::filesystem::path shaders;
};

/// Binds what the user's file of keys says, if there is one, and makes a message of its mistakes.
void read_keys(ViewerStart& start)
{
    const std::filesystem::path file = user_file("keys.toml");
    if (file.empty() || !std::filesystem::exists(file)) return;
    const std::vector<Error> errors = start.keys.read(file);
    for (const Error& error : errors) log_info(error.text());
    if (errors.empty()) return;
    start.message += (start.message.empty() ? "" : "\n") + errors.front().text();
    if (errors.size() > 1) start.message += fmt::format("\nand {} more, told in the terminal", errors.size() - 1);
}

/// What the window remembers; a damaged file makes a message, and all is as on the first day.
WindowState read_state(const std::filesystem::path& file, std::string& message)
{
    try {
        return read_window_state(file);
    } catch (const Error& error) {
        log_warning(error.text());
        message = error.text();
        return {};
    }
}

/// The sources that are watched: those asked for, or those beside a program that still stands in its build tree.
std::filesystem::path shader_folder(const std::filesystem::path& wanted)
{
    const bool built_here = this_program().parent_path() == shaders::program_folder();
    if (wanted.empty()) return built_here ? shaders::source_folder() : "";
    if (!std::filesystem::is_directory(wanted)) {
        throw Error(ExitCode::usage, "no folder of shaders is there", "--shaders " + wanted.string(),
                    "there is no such folder", "give the folder that has lib, shared and techniques in it");
    }
    return std::filesystem::canonical(wanted);
}

int run(const Options& o)
{
    const auto read_start = std::chrono::steady_clock::now();
    SceneInput scene = read_scene_input(o.scene, o.frame);
    const double read_ms = ms_since(read_start);
    const SettingChain chain(o.frame, scene);
    ViewerStart start;
    start.scene = {scene_path(o.scene.scene), make_request(o.frame, scene, chain), scene.file, {}};
    start.continuous = o.continuous;
    start.shaders = shader_folder(o.shaders);

    const std::filesystem::path state_file = user_file("window.toml");
    WindowState state = read_state(state_file, start.message);
    read_keys(start);
    if (o.frame.size) state.place.size = ivec2(*o.frame.size);
    const bool camera_given =
        !o.frame.camera.empty() || o.frame.eye || !o.frame.config.empty() || o.frame.from != CameraFrom::anywhere;
    if (state.scene == start.scene.file && !camera_given)
        start.scene.frame.camera = state.camera;
    else
        tell_camera(scene, o.frame);
    start.bookmarks = state.bookmarks;
    start.recent = state.recent;
    start.settings_file = state.settings_file;
    Window window("Atrium", state.place);
    EngineOptions options = engine_options(o.scene);
    options.window = window.window_system();
    Engine engine(options);
    start.scene.frame.settings = chain.apply(engine.device().report().is_cpu);
    const auto load_start = std::chrono::steady_clock::now();
    const SceneDescription description = scene.description();
    engine.load(description);
    start.scene.facts = gather_facts(description, engine.scene(), read_ms + ms_since(load_start));
    SceneOpener opener(engine, o.scene, o.frame, std::move(scene));
    Viewer viewer(window, engine, opener, start);
    viewer.run();
    write_window_state(state_file, {window.place(), viewer.scene(), viewer.camera(), viewer.settings_file(),
                                    viewer.bookmarks(), viewer.recent()});
    return verdict(engine);
}

} // namespace

Run add_view_command(CLI::App& app)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("view", "fly through a scene in a window");
    add_scene_options(*command, o->scene);
    add_frame_options(*command, o->frame);
    command->add_flag("--continuous", o->continuous, "draw frame after frame, also when nothing changes");
    command
        ->add_option("--shaders", o->shaders,
                     "compile the shaders of this folder again when they change (in a build tree: its own)")
        ->envname("ATRIUM_SHADER_DIR");
    command->footer("Example:\n  atrium view out/courtyard/courtyard.toml --camera hero");
    return [o] { return run(*o); };
}

} // namespace atrium::app
