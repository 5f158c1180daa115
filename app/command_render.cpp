// `atrium render`: frames to files.

#include "app/commands.hpp"
#include "app/config.hpp"
#include "app/json_output.hpp"
#include "app/output.hpp"
#include "app/resume.hpp"
#include "app/scene_input.hpp"
#include "app/stats.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/log.hpp"
#include "renderer/core/output_guard.hpp"
#include "renderer/core/progress.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace atrium::app {
namespace {

struct Options {
    SceneOptions scene;
    FrameOptions frame;
    std::filesystem::path output;
    std::vector<std::string> aovs; ///< "NAME=FILE.exr"
    std::string frames;
    double dt = 1.0 / 60.0;
    std::string path;
    bool resume = false;
    std::filesystem::path stats, graph;
};

void write_graph(const std::filesystem::path& file, const graph::Runner& runner);

/// The frames of one run, each by its index.
struct FrameSequence {
    const Options& options;
    const OutputPlan& outputs;
    const FrameRequest& request; ///< of a frame without a path
    const CameraPath& path;
    double start_time;
    std::string scene_mark;

    [[nodiscard]] double time(std::size_t i) const
    {
        return start_time + options.dt * static_cast<double>(outputs.first_frame() + i);
    }
    [[nodiscard]] FrameRequest frame(std::size_t i) const
    {
        FrameRequest out = request;
        out.camera = camera_at(path, time(i), request.camera);
        out.previous_camera = camera_at(path, time(i) - options.dt, request.camera);
        out.frame_index = outputs.first_frame() + i;
        out.time = time(i);
        out.time_step = options.dt;
        return out;
    }
    [[nodiscard]] ImageMetadata metadata(std::size_t i) const
    {
        const FrameRequest drawn = frame(i);
        ImageMetadata out = describe_frame(drawn, drawn.time);
        if (outputs.numbered()) out[resume_key] = resume_text(scene_mark, drawn.previous_camera);
        return out;
    }
    /// Indices of those to be drawn: all but, with --resume, those whose files are there.
    [[nodiscard]] std::vector<std::size_t> missing() const
    {
        std::vector<std::size_t> out;
        for (std::size_t i = 0; i < outputs.frame_count(); ++i) {
            if (!options.resume || !outputs.is_done(i, metadata(i))) out.push_back(i);
        }
        return out;
    }
};

void draw_frames(const FrameSequence& sequence, Engine& engine, StatsRecorder& stats)
{
    const std::vector<std::size_t> missing = sequence.missing();
    const std::size_t done = sequence.outputs.frame_count() - missing.size();
    if (done > 0) log_info(fmt::format("{} of {} frames are there already", done, sequence.outputs.frame_count()));
    std::optional<Progress> progress;
    if (missing.size() > 1) progress.emplace("rendering", missing.size());
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t n = 0; n < missing.size(); ++n) {
        const std::size_t i = missing[n];
        const FrameResult frame = engine.render(sequence.frame(i));
        stats.add(frame);
        if (sequence.outputs.writes(i)) sequence.outputs.write(i, frame, sequence.metadata(i));
        const double mean_ms = ms_since(start) / static_cast<double>(n + 1);
        if (progress) progress->advance(1, time_left(mean_ms, missing.size() - n - 1));
    }
}

void refuse_inputs(const Options& o, const OutputPlan& outputs, std::span<const std::filesystem::path> inputs)
{
    outputs.refuse_inputs(inputs);
    refuse_overwriting(std::array{OutputFile{"--stats", o.stats}, OutputFile{"--graph", o.graph}}, inputs);
}

int run(const Options& o)
{
    // Everything that can be wrong with the command line is found out before the device is touched.
    const OutputPlan outputs(o.output, o.frames, o.aovs);
    if (o.resume && !outputs.numbered()) {
        throw Error(ExitCode::usage, "--resume continues numbered frames only", "--resume",
                    fmt::format("{} has no # in its name", o.output.string()), "for example -o frame.####.png");
    }
    if (!std::isfinite(o.dt)) { // CLI11 lets "nan" pass
        throw Error(ExitCode::usage, "--dt takes a finite number of seconds", "--dt", "", "for example --dt 0.04");
    }
    refuse_inputs(o, outputs, std::array{o.scene.scene, o.frame.config});
    const auto start = std::chrono::steady_clock::now();
    const SceneInput scene = read_scene_input(o.scene, o.frame);
    refuse_inputs(o, outputs, scene.files); // now with what the scene file and the OBJ name
    tell_camera(scene, o.frame);
    const SettingChain chain(o.frame, scene);
    FrameRequest request = make_request(o.frame, scene, chain);
    for (const AovOutput& aov : outputs.aovs()) request.aovs.push_back(parse_aov(aov.name, request.lights));
    const CameraPath path = find_path(o.path, scene.file);
    const double start_time = o.frame.time.value_or(scene.config.time.value_or(0));
    outputs.check_writable();
    const double read_ms = ms_since(start);

    Engine engine(engine_options(o.scene));
    log_verbose(fmt::format("device: {}", engine.device().report().name));
    request.settings = chain.apply(engine.device().report().is_cpu);
    const auto load_start = std::chrono::steady_clock::now();
    engine.load(scene.description());

    // Frames that are not written are drawn all the same: the last one may depend on them, and their times count.
    request.want_picture = outputs.wants_png();
    request.want_hdr = !outputs.wants_png();

    StatsRecorder stats(engine, request.size);
    stats.set_load_ms(read_ms + ms_since(load_start));
    request.want_statistics = !o.stats.empty();
    if (request.want_statistics)
        static_cast<void>(engine.render(request)); // warms pipelines, so that no compiler is timed

    const FrameSequence sequence{o, outputs, request, path, start_time, scene_mark(scene)};
    draw_frames(sequence, engine, stats);
    if (!o.graph.empty()) write_graph(o.graph, engine.runner());
    if (!o.stats.empty()) write_json_text(o.stats.string(), stats.to_json());
    log_info(fmt::format("{}", o.output.string()));
    return verdict(engine);
}

void write_graph(const std::filesystem::path& file, const graph::Runner& runner)
{
    write_json_text(file.string(), file.extension() == ".dot" ? runner.plan_dot() : runner.plan_text());
}

} // namespace

Run add_render_command(CLI::App& app)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("render", "draw a scene to a picture");
    add_scene_options(*command, o->scene);
    add_frame_options(*command, o->frame);
    command->add_option("-o,--output", o->output, "OUT.png (8-bit sRGB) or OUT.exr (linear, before exposure)")
        ->required();
    command->add_option("--aov", o->aovs, "NAME=FILE.exr: an intermediate image (docs/aovs.md)")
        ->allow_extra_args(false);
    command->add_option("--frames", o->frames, "N frames from 0, or A-B; OUT.####.png writes each");
    command->add_option("--dt", o->dt, "seconds between frames (1/60)")->check(CLI::NonNegativeNumber);
    command->add_option("--path", o->path, "move the camera along a path of the scene file");
    command->add_flag("--resume", o->resume,
                      "leave out frames whose files are there, whole and for the same scene and settings");
    command->add_option("--stats", o->stats, "times and counts as JSON");
    command->add_option("--graph", o->graph, "the frame graph: FILE.txt or Graphviz FILE.dot");
    command->footer(
        "Example:\n  atrium render out/courtyard/courtyard.toml --camera hero --set exposure.ev100=0.5 -o hero.png");
    return [o] { return run(*o); };
}

} // namespace atrium::app
