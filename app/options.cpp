#include "app/options.hpp"

#include "renderer/core/error.hpp"
#include "renderer/core/nearest_name.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iostream>
#include <span>

namespace atrium::app {
namespace {

/// The whole text as numbers between separators; empty when it is anything else.
template <class T, std::size_t N>
std::optional<std::array<T, N>> parse_numbers(std::string_view text, char separator)
{
    std::array<T, N> out{};
    for (std::size_t i = 0; i < N; ++i) {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out[i]);
        if (error != std::errc{}) return std::nullopt;
        if constexpr (std::is_floating_point_v<T>) {
            if (!std::isfinite(out[i])) return std::nullopt;
        }
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (i + 1 < N) {
            if (text.empty() || text.front() != separator) return std::nullopt;
            text.remove_prefix(1);
        }
    }
    return text.empty() ? std::optional(out) : std::nullopt;
}

CLI::Option* add_vector(CLI::App& command, const std::string& name, std::optional<vec3>& target,
                        const std::string& help)
{
    return command.add_option_function<std::string>(
        name,
        [&target, name](const std::string& text) {
            const auto xyz = parse_numbers<float, 3>(text, ',');
            if (!xyz) throw CLI::ValidationError(name, fmt::format("takes three numbers X,Y,Z, not \"{}\"", text));
            target = vec3((*xyz)[0], (*xyz)[1], (*xyz)[2]);
        },
        help);
}

/// CLI11's ranges let "nan" pass.
CLI::Validator finite()
{
    return CLI::Validator(
        [](std::string& text) {
            double value = 0;
            const bool is_number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
            return is_number ? std::string() : fmt::format("takes a finite number, not \"{}\"", text);
        },
        "NUMBER");
}

/// Long names of all options that a command line may hold.
std::vector<std::string> option_names(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

std::vector<std::string> command_names(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

/// Throws if the command line does not begin with a command. Must come first: options after an unknown command have no
/// meaning.
void check_command(const CLI::App& app, std::span<const char* const> arguments)
{
    const std::vector<std::string> commands = command_names(app);
    const std::string all = fmt::format("the commands are {}", fmt::join(commands, ", "));
    const std::string help = fmt::format("`{} --help` lists what there is", app.get_name());
    if (arguments.empty()) throw Error(ExitCode::usage, "no command given", app.get_name(), all, help);
    const std::string first = arguments.front();
    if (first.starts_with('-')) {
        const std::vector<std::string> options = option_names(app);
        const std::string name = first.substr(0, first.find('='));
        if (std::find(options.begin(), options.end(), name) != options.end()) return;
        throw Error(ExitCode::usage, fmt::format("no command before {}", name), app.get_name(), all,
                    did_you_mean(name, options, "begin with a command: atrium COMMAND OPTIONS"));
    }
    if (std::find(commands.begin(), commands.end(), first) != commands.end()) return;
    throw Error(ExitCode::usage, fmt::format("unknown command \"{}\"", first), app.get_name(), all,
                did_you_mean(first, commands, help));
}

[[noreturn]] void refuse(const CLI::App& app, std::span<const char* const> arguments, const std::string& why)
{
    const CLI::App* command = &app;
    if (!app.get_subcommands().empty()) command = app.get_subcommands().front();
    const std::vector<std::string> options = option_names(*command);
    const std::string help = fmt::format("`{} --help` lists what there is",
                                         command == &app ? app.get_name() : app.get_name() + " " + command->get_name());
    // The first argument that looks like an option but is none.
    for (const char* argument : arguments) {
        const std::string_view word = argument;
        const std::string name(word.substr(0, word.find('=')));
        if (name.starts_with("--") && std::find(options.begin(), options.end(), name) == options.end()) {
            throw Error(ExitCode::usage, fmt::format("unknown option {}", name), command->get_name(),
                        did_you_mean(name, options), help);
        }
    }
    throw Error(ExitCode::usage, "the command line is not complete or not understood", command->get_name(), why, help);
}

} // namespace

void add_device_options(CLI::App& command, SceneOptions& o)
{
    command.add_option("--device", o.device, "device by name or index (see `atrium devices`)");
    command.add_flag("--validate", o.validate, "Khronos validation with synchronisation checks; a message ends with 5");
}

CLI::Option* add_size_option(CLI::App& command, std::optional<uvec2>& size, const std::string& help)
{
    return command.add_option_function<std::string>(
        "--size",
        [&size](const std::string& text) {
            const auto wh = parse_numbers<std::uint32_t, 2>(text, 'x');
            if (!wh || (*wh)[0] < 1 || (*wh)[1] < 1 || (*wh)[0] > 16384 || (*wh)[1] > 16384) {
                throw CLI::ValidationError("--size", fmt::format("takes WxH, each 1 to 16384, not \"{}\"", text));
            }
            size = uvec2((*wh)[0], (*wh)[1]);
        },
        help);
}

void add_scene_options(CLI::App& command, SceneOptions& o)
{
    command.add_option("SCENE", o.scene, "a bake (.atrium), a scene file (.toml), or an OBJ (baked first)")->required();
    add_device_options(command, o);
    command.add_option("--bake-scale", o.bake_scale, "scale when SCENE is an OBJ")->check(CLI::PositiveNumber);
    command.add_option("--bake-up", o.bake_up, "up axis when SCENE is an OBJ")->check(CLI::IsMember({"y", "z"}));
}

void add_frame_options(CLI::App& command, FrameOptions& o)
{
    add_size_option(command, o.size, "picture size WxH (1280x720)");
    command.add_option("--camera", o.camera, "a camera of the scene file");
    CLI::Option* eye = add_vector(command, "--eye", o.eye, "camera position X,Y,Z, m");
    CLI::Option* target = add_vector(command, "--target", o.target, "point looked at X,Y,Z, m");
    eye->needs(target);
    target->needs(eye);
    command.add_option("--fov", o.fov, "vertical field of view, degrees (60)")
        ->check(finite())
        ->check(CLI::Range(1.0, 170.0));
    const auto set_from = [&o](const std::string& text) {
        o.from = text == "inside" ? CameraFrom::inside : CameraFrom::outside;
    };
    command
        .add_option_function<std::string>("--from", set_from,
                                          "place of the default camera: outside or inside the scene "
                                          "(inside if its middle is a room)")
        ->check(CLI::IsMember({"outside", "inside"}));
    command.add_option("--light", o.lights, "add a light: TYPE,key=value,… (docs/lights.md)")->allow_extra_args(false);
    command.add_flag("--no-lights", o.no_lights, "drop the scene's lights and the default sun");
    command.add_option("--set", o.set, "a setting: key=value (see `atrium settings`)")->allow_extra_args(false);
    command.add_option("--preset", o.preset, "a named set of settings");
    command.add_option("--config", o.config, "settings from a TOML file, or those inside a picture (.png, .exr)");
    command.add_option("--time", o.time, "scene time, s")->check(finite());
}

std::optional<int> parse_command_line(CLI::App& app, int argc, const char* const* argv)
{
    const auto arguments = std::span(argv, static_cast<std::size_t>(argc)).subspan(argc > 0 ? 1 : 0);
    check_command(app, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& done) {
        return app.exit(done); // --help, --version
    } catch (const CLI::ParseError& error) {
        refuse(app, arguments, error.what());
    }
    return std::nullopt;
}

} // namespace atrium::app
