#include "assetconv/commands.hpp"

#include "assetconv/bake.hpp"
#include "assetconv/command_line.hpp"
#include "assetconv/courtyard/courtyard.hpp"
#include "assetconv/info.hpp"
#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/hash.hpp"
#include "renderer/core/jobs.hpp"
#include "renderer/core/log.hpp"
#include "renderer/core/nearest_name.hpp"
#include "renderer/core/output_guard.hpp"
#include "renderer/scene/bake_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

namespace atrium {
namespace {

constexpr const char* program = "assetconv";

void print(std::string_view text)
{
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0)
        throw Error(ExitCode::environment, "cannot write the output", "standard output", "",
                    "free some space or choose a file");
}

void write_json(const std::string& target, const nlohmann::ordered_json& json)
{
    if (target == "-")
        print(to_text(json));
    else
        write_text_file(target, to_text(json));
}

/// A command: its options, added to CLI11's description, and what it does once they are read.
class Command {
public:
    virtual ~Command() = default;
    virtual void run() = 0;

    void add_common(CLI::App& app)
    {
        app.add_flag("-q,--quiet", quiet_, "say nothing but warnings and errors");
        app.add_flag("-v,--verbose", verbose_, "say more, with times");
    }
    void apply_common() const
    {
        set_log_level(quiet_ ? LogLevel::quiet : verbose_ ? LogLevel::verbose : LogLevel::normal);
    }

private:
    bool quiet_ = false, verbose_ = false;
};

class BakeCommand : public Command {
public:
    explicit BakeCommand(CLI::App& app)
    {
        app.add_option("scene", input_, "the .obj file")->required()->type_name("SCENE.obj");
        app.add_option("-o,--output", output_, "default: the OBJ's name with .atrium, in the current folder")
            ->type_name("OUT.atrium");
        app.add_option("--scale", scale_, "metres per unit of the file")->type_name("S")->capture_default_str();
        app.add_option("--up", up_, "the file's up axis: y or z")->type_name("y|z")->capture_default_str();
        app.add_option("--textures", textures_, "rgba8, or bc to save space and lose a little quality")
            ->type_name("rgba8|bc")
            ->capture_default_str();
        app.add_option("--max-texture-size", max_size_, "halve larger textures until they fit")->type_name("N");
        app.add_option("--normal-y", normal_y_, "where green points in normal maps; auto finds out")
            ->type_name("auto|up|down")
            ->capture_default_str();
        app.add_option("--smooth-angle", smooth_angle_,
                       "for normals that the file lacks: degrees up to which edges are smoothed (default 40, or the "
                       "file's smoothing groups)")
            ->type_name("DEG");
        app.add_option("--two-sided", two_sided_, "auto: where winding and normals disagree, and masks")
            ->type_name("auto|on|off")
            ->capture_default_str();
        app.add_flag("--strict", strict_, "missing textures, MTL files and materials are errors");
        app.add_option("--jobs", jobs_, "threads (default: all cores)")->type_name("N");
        app.add_option("--json", json_, "write what `info --json` tells; - for standard output")->type_name("FILE");
        app.add_option("--dependencies", dependencies_,
                       "write the inputs of the bake as JSON, to know when to bake again")
            ->type_name("FILE");
        app.footer("Example:\n  assetconv bake sponza.obj --scale 0.01 -o sponza.atrium");
    }

    void run() override
    {
        const BakeOptions options = read_options();
        const std::filesystem::path output = output_.empty() ? options.input.stem().string() + ".atrium" : output_;
        const std::array outputs{OutputFile{"-o", output}, OutputFile{"--json", json_},
                                 OutputFile{"--dependencies", dependencies_}};
        refuse_overwriting(outputs, std::array{options.input});
        InputRecord inputs;
        const BakeData data = bake_scene(options, &inputs);
        refuse_overwriting(outputs, inputs.files()); // now with the MTL files and textures
        write_bake(output, data);
        const std::vector<std::string> warnings = warning_lines(data.scene);
        for (const std::string& line : warnings) log_warning(line);
        if (!dependencies_.empty()) write_dependencies(output, std::move(inputs), warnings);
        const std::uint64_t size = std::filesystem::file_size(output);
        log_info(fmt::format("{}: {} triangles, {} meshes, {} materials, {} textures, {:.1f} MiB", output.string(),
                             data.scene.index_count / 3, data.scene.meshes.size(), data.scene.materials.size(),
                             data.scene.textures.size(), static_cast<double>(size) / (1024.0 * 1024.0)));
        if (!json_.empty()) write_json(json_, info_json(data.scene, size));
    }

private:
    [[nodiscard]] BakeOptions read_options() const
    {
        BakeOptions o;
        o.input = input_;
        check_range("--scale", scale_, 1e-9, 1e9);
        o.scale = static_cast<float>(scale_);
        o.up = choose<UpAxis>("--up", up_, {{"y", UpAxis::y}, {"z", UpAxis::z}});
        o.textures = choose<TextureEncoding>("--textures", textures_,
                                             {{"rgba8", TextureEncoding::rgba8}, {"bc", TextureEncoding::bc}});
        check_range("--max-texture-size", static_cast<double>(max_size_), 1, max_image_side);
        o.max_texture_size = static_cast<std::uint32_t>(max_size_);
        o.normal_y = choose<NormalY>("--normal-y", normal_y_,
                                     {{"auto", NormalY::automatic}, {"up", NormalY::up}, {"down", NormalY::down}});
        if (smooth_angle_) {
            check_range("--smooth-angle", *smooth_angle_, 0, 180);
            o.smooth_angle = static_cast<float>(*smooth_angle_);
        }
        o.two_sided = choose<TwoSided>("--two-sided", two_sided_,
                                       {{"auto", TwoSided::automatic}, {"on", TwoSided::on}, {"off", TwoSided::off}});
        o.strict = strict_;
        check_range("--jobs", jobs_, 0, 1024);
        set_job_threads(jobs_);
        return o;
    }

    /// Written after the bake: a record without its bake, or of another bake, is useless.
    void write_dependencies(const std::filesystem::path& output, InputRecord inputs,
                            const std::vector<std::string>& warnings) const
    {
        std::error_code unknown;
        inputs.add_file(
            std::filesystem::read_symlink("/proc/self/exe", unknown)); // another assetconv bakes another way
        inputs.result = hash64(std::as_bytes(std::span(BakeFile(output).table())));
        inputs.notes = warnings;
        write_text_file(dependencies_, inputs.to_json());
    }

    std::string input_, output_, json_, dependencies_, up_ = "y", textures_ = "rgba8", normal_y_ = "auto",
                                                       two_sided_ = "auto";
    double scale_ = 1;
    std::optional<double> smooth_angle_;
    std::int64_t max_size_ = max_image_side;
    bool strict_ = false;
    int jobs_ = 0;
};

class InfoCommand : public Command {
public:
    explicit InfoCommand(CLI::App& app)
    {
        app.add_option("file", file_, "the bake")->required()->type_name("FILE.atrium");
        app.add_option("--json", json_, "write JSON; - for standard output")->type_name("FILE|-");
        app.footer("Example:\n  assetconv info sponza.atrium --json -");
    }
    void run() override
    {
        refuse_overwriting(std::array{OutputFile{"--json", json_}}, std::array{std::filesystem::path(file_)});
        const BakeFile bake(file_);
        if (json_.empty())
            print(info_text(bake.scene(), bake.bytes().size()));
        else
            write_json(json_, info_json(bake.scene(), bake.bytes().size()));
    }

private:
    std::string file_, json_;
};

class VerifyCommand : public Command {
public:
    explicit VerifyCommand(CLI::App& app)
    {
        app.add_option("file", file_, "the bake")->required()->type_name("FILE.atrium");
        app.footer("Example:\n  assetconv verify sponza.atrium");
    }
    void run() override
    {
        std::string text;
        for (const std::string& line : verify_bake(file_)) text += line + "\n";
        if (log_level() != LogLevel::quiet) print(text);
    }

private:
    std::string file_;
};

class CourtyardCommand : public Command {
public:
    explicit CourtyardCommand(CLI::App& app)
    {
        app.add_option("folder", folder_, "where to write courtyard.obj, its MTL and textures")
            ->required()
            ->type_name("DIR");
        app.add_option("--seed", seed_, "another seed, another court")->type_name("N")->capture_default_str();
        app.add_option("--detail", detail_, "how many triangles and texels")
            ->type_name("low|medium|high")
            ->capture_default_str();
        app.footer(
            "Example:\n  assetconv courtyard out/courtyard --seed 7 && assetconv bake out/courtyard/courtyard.obj");
    }
    void run() override
    {
        using Detail = CourtyardOptions::Detail;
        check_range("--seed", static_cast<double>(seed_), 0, 4294967295.0);
        CourtyardOptions options;
        options.folder = folder_;
        options.seed = static_cast<std::uint32_t>(seed_);
        options.detail = choose<Detail>("--detail", detail_,
                                        {{"low", Detail::low}, {"medium", Detail::medium}, {"high", Detail::high}});
        write_courtyard(options);
        log_info(fmt::format("wrote {}", (options.folder / "courtyard.obj").string()));
    }

private:
    std::string folder_, detail_ = "medium";
    std::int64_t seed_ = 1;
};

class ParseCommand : public Command {
public:
    explicit ParseCommand(CLI::App& app)
    {
        app.add_option("scene", input_, "the .obj file")->required()->type_name("SCENE.obj");
        app.footer("Example:\n  time assetconv parse sponza.obj");
    }
    void run() override
    {
        BakeOptions options;
        options.input = input_;
        parse_scene(options);
    }

private:
    std::string input_;
};

/// All commands, in the order of the help.
struct CommandLine {
    CLI::App app{"assetconv bakes OBJ scenes into .atrium files and tells what is in them.", program};
    std::vector<std::pair<CLI::App*, std::unique_ptr<Command>>> commands;

    CommandLine()
    {
        app.set_version_flag("--version", fmt::format("{} {}", program, ATRIUM_VERSION));
        app.footer(
            "Examples:\n  assetconv bake sponza.obj --scale 0.01 -o sponza.atrium\n  assetconv info sponza.atrium\n\n"
            "`assetconv COMMAND --help` tells more about each command.");
        add<BakeCommand>("bake", "bake an OBJ and its MTL and textures into one file");
        add<InfoCommand>("info", "tell what a bake holds");
        add<VerifyCommand>("verify", "check every byte of a bake");
        add<ParseCommand>("parse", "read an OBJ and decode its textures, and keep nothing: a floor for benchmarks");
        add<CourtyardCommand>("courtyard", "write a court made by code, to try things on");
    }

    template <class T>
    void add(const char* name, const char* description)
    {
        CLI::App* sub = app.add_subcommand(name, description);
        sub->allow_extras(); // refuse_extras() knows better words for them
        auto command = std::make_unique<T>(*sub);
        command->add_common(*sub);
        commands.emplace_back(sub, std::move(command));
    }

    void refuse_unknown_command(const std::vector<std::string>& arguments) const
    {
        std::vector<std::string> names;
        for (const auto& [sub, command] : commands) names.push_back(sub->get_name());
        const std::string all = fmt::format("the commands are: {}", fmt::join(names, ", "));
        if (arguments.empty())
            throw Error(ExitCode::usage, "no command given", "command line", all, "`assetconv --help` lists them");
        const std::string& first = arguments.front();
        if (first == "--help" || first == "-h" || first == "--version") return;
        if (std::find(names.begin(), names.end(), first) != names.end()) return;
        if (first.starts_with('-')) names = {"--help", "--version"};
        throw Error(ExitCode::usage,
                    fmt::format("unknown {} \"{}\"", first.starts_with('-') ? "option" : "command", first),
                    "command line", all, did_you_mean(first, names, "`assetconv --help` lists them"));
    }
};

} // namespace

int run_assetconv(std::vector<std::string> arguments)
{
    CommandLine line;
    line.refuse_unknown_command(arguments);
    std::reverse(arguments.begin(), arguments.end()); // CLI11 takes its vector from the end
    try {
        line.app.parse(std::move(arguments));
    } catch (const CLI::Success& wanted) { // --help, --version
        return line.app.exit(wanted);
    } catch (const CLI::ParseError& e) {
        for (const auto& [sub, command] : line.commands) {
            if (sub->parsed()) refuse_extras(*sub, program); // a mistyped option tells more than a missing argument
        }
        throw Error(ExitCode::usage, e.what(), "command line", "", "`assetconv --help` tells what may be typed");
    }
    for (const auto& [sub, command] : line.commands) {
        if (!sub->parsed()) continue;
        refuse_extras(*sub, program);
        command->apply_common();
        command->run();
    }
    return static_cast<int>(ExitCode::done);
}

} // namespace atrium
