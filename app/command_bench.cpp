// `atrium bench`: what each pass costs, beside its floor.

#include "app/bench_floors.hpp"
#include "app/child_process.hpp"
#include "app/commands.hpp"
#include "app/json_output.hpp"
#include "app/scene_input.hpp"
#include "app/stats.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/output_guard.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>

namespace atrium::app {
namespace {

struct Options {
    SceneOptions scene;
    FrameOptions frame;
    bool floors = false;
    std::vector<std::string> passes;
    int runs = 5;
    std::filesystem::path source;
    std::string json;
};

/// Times by name, and the order in which names first came.
class Samples {
public:
    void add(const std::string& name, double ms)
    {
        if (!values_.contains(name)) names_.push_back(name);
        values_[name].push_back(ms);
    }
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    [[nodiscard]] const std::vector<double>* find(const std::string& name) const
    {
        const auto found = values_.find(name);
        return found == values_.end() ? nullptr : &found->second;
    }

private:
    std::vector<std::string> names_;
    std::map<std::string, std::vector<double>> values_;
};

/// Which floor a run is held against; empty for floors and where there is none.
std::string floor_of(const std::string& name)
{
    if (name.starts_with("floor.")) return "";
    if (name.starts_with("gbuffer") || name == "cull+gbuffer") return "floor.gbuffer";
    if (name == "lighting") return "floor.lighting";
    if (name.starts_with("ao") || name.starts_with("sky.ao")) return "floor.ao_taps";
    if (name.starts_with("visibility") || name.starts_with("sky.visibility")) return "floor.shadow_taps";
    if (name == "load") return "floor.copy";
    if (name == "parse") return "load";
    return "floor.t16";
}

bool is_floor(const std::string& pass)
{
    constexpr std::array floors{"floor.t16", "floor.gbuffer", "floor.lighting", "floor.ao_taps", "floor.shadow_taps"};
    return std::find(floors.begin(), floors.end(), pass) != floors.end();
}

/// Passes of add_culled_gbuffer().
bool fills_gbuffer(const std::string& pass)
{
    return pass.starts_with("gbuffer") || pass.starts_with("cull") || pass.starts_with("depth_");
}

void bench_load(Engine& engine, const SceneInput& scene, const std::filesystem::path& source, int runs,
                Samples& samples)
{
    const std::filesystem::path bake = scene.bakes.front()->path();
    const BulkRange bulk = bulk_range(*scene.bakes.front());
    for (int run = -1; run < runs; ++run) { // the first warms the page cache
        const double copy = run_copy_floor(bake, bulk);
        engine.unload();
        const auto start = std::chrono::steady_clock::now();
        const BakeFile fresh(bake);
        SceneDescription description = scene.description();
        description.bakes.front() = &fresh;
        engine.load(description);
        const double load = ms_since(start);
        if (run < 0) continue;
        samples.add("load", load);
        samples.add("floor.copy", copy);
    }
    if (source.empty()) return;
    const std::string converter = (this_program().parent_path() / "assetconv").string();
    for (int run = 0; run < 3; ++run) {
        const auto start = std::chrono::steady_clock::now();
        if (const int code = ChildProcess({converter, "parse", source.string(), "--quiet"}).wait(); code != 0) {
            throw Error(ExitCode::input, fmt::format("{} could not be parsed", source.string()), "--source",
                        fmt::format("assetconv ended with {}", code), "");
        }
        samples.add("parse", ms_since(start));
    }
}

void bench_frames(Engine& engine, FrameRequest request, bool floors, int runs, Samples& samples)
{
    request.remember = true;
    for (int run = -2; run < runs; ++run) { // the first two warm the pipelines and what frames remember
        Samples discarded;
        Samples& into = run < 0 ? discarded : samples;
        // First, for the passes follow in a frame like it then, and not the floors, which leave caches cold.
        request.timers = gpu::TimerMode::overlapped;
        const FrameResult frame = engine.render(request);
        into.add("frame", frame.record_ms + frame.stats.wall_ms - frame.stats.cpu_ms);
        into.add("record", frame.record_ms);
        request.timers = gpu::TimerMode::serialized;
        double culled_gbuffer = 0;
        for (const graph::PassStats& pass : engine.render(request).stats.passes) {
            if (pass.name.starts_with("readback.")) continue;
            into.add(pass.name, pass.gpu_ms);
            if (fills_gbuffer(pass.name)) culled_gbuffer += pass.gpu_ms;
        }
        into.add("cull+gbuffer", culled_gbuffer);
        if (!floors) continue;
        for (const auto& [name, ms] : run_device_floors(engine, request)) {
            if (is_floor(name)) into.add(name, ms);
        }
    }
}

/// Median of the runs' own ratios: what slows a run down slows its floor, drawn right after it, too. Where there are
/// not as many runs of both, the ratio of medians.
double ratio_to(const std::vector<double>& ms, const std::vector<double>& floor_ms)
{
    if (ms.size() != floor_ms.size()) return median(ms) / median(floor_ms);
    std::vector<double> ratios(ms.size());
    std::transform(ms.begin(), ms.end(), floor_ms.begin(), ratios.begin(), std::divides<>());
    return median(ratios);
}

nlohmann::ordered_json report(const Samples& samples, const std::vector<std::string>& wanted, const std::string& device)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    fmt::print("{}\n{:<20} {:>10} {:>10} {:>10}  {:<16} {:>7}\n", device, "", "median ms", "min", "max", "floor",
               "ratio");
    for (const std::string& name : samples.names()) {
        const bool is_wanted = wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
        if (!is_wanted && !name.starts_with("floor.")) continue;
        const std::vector<double>& ms = *samples.find(name);
        const double middle = median(ms);
        const auto [low, high] = std::minmax_element(ms.begin(), ms.end());
        const std::string floor = floor_of(name);
        const std::vector<double>* floor_ms = floor.empty() ? nullptr : samples.find(floor);
        nlohmann::ordered_json row{{"name", name},    {"median_ms", middle}, {"min_ms", *low},
                                   {"max_ms", *high}, {"floor", nullptr},    {"ratio", nullptr}};
        fmt::print("{:<20} {:>10.3f} {:>10.3f} {:>10.3f}", name, middle, *low, *high);
        if (floor_ms) {
            row["floor"] = floor;
            row["ratio"] = ratio_to(ms, *floor_ms);
            fmt::print("  {:<16} {:>7.3f}", floor, ratio_to(ms, *floor_ms));
        }
        fmt::print("\n");
        rows.push_back(row);
    }
    return {{"device", device}, {"runs", rows}};
}

int run(const Options& o)
{
    const std::array output{OutputFile{"--json", o.json}};
    refuse_overwriting(output, std::array{o.scene.scene, o.frame.config, o.source});
    const SceneInput scene = read_scene_input(o.scene, o.frame);
    refuse_overwriting(output, scene.files);
    tell_camera(scene, o.frame);
    const SettingChain chain(o.frame, scene);
    FrameRequest request = make_request(o.frame, scene, chain);

    Engine engine(engine_options(o.scene));
    request.settings = chain.apply(engine.device().report().is_cpu);

    Samples samples;
    const bool only_load = o.passes.size() == 1 && o.passes.front() == "load";
    const bool load = o.passes.empty() || std::find(o.passes.begin(), o.passes.end(), "load") != o.passes.end();
    const bool is_obj = o.scene.scene.extension() == ".obj";
    engine.load(scene.description());
    if (!only_load) bench_frames(engine, request, o.floors, o.runs, samples);
    if (load) bench_load(engine, scene, is_obj ? o.scene.scene : o.source, o.runs, samples);
    std::vector<std::string> wanted = o.passes;
    if (load && !wanted.empty()) wanted.emplace_back("parse");
    const nlohmann::ordered_json json = report(samples, wanted, engine.device().report().name);
    if (!o.json.empty()) write_json_text(o.json, json.dump(2) + "\n");
    return verdict(engine);
}

} // namespace

Run add_bench_command(CLI::App& app)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("bench", "time the passes of a frame, each beside its floor");
    add_scene_options(*command, o->scene);
    add_frame_options(*command, o->frame);
    command->add_flag("--floors", o->floors, "also draw the floors that passes are held against");
    command->add_option("--passes", o->passes, "only these passes (NAME,…); load, frame and record are names too")
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--runs", o->runs, "measured runs (5)")->check(CLI::Range(1, 1000));
    command->add_option("--source", o->source, "the OBJ of the bake: `load` is then also held against parsing it")
        ->check(CLI::ExistingFile);
    command->add_option("--json", o->json, "figures as JSON to a file, or - for the terminal");
    command->footer("Example:\n  atrium bench sponza.atrium --eye -11.5,1.7,-0.4 --target 10,3.5,-0.4 --floors\n"
                    "Passes are timed with full barriers around each timestamp, `frame` without.");
    return [o] { return run(*o); };
}

} // namespace atrium::app
