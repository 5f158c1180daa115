// `atrium`: the command line.

#include "app/commands.hpp"
#include "app/options.hpp"
#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/log.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <csignal>
#include <cstdio>
#include <new>
#include <utility>
#include <vector>

namespace {

using namespace atrium;

/// Leaves no half file behind and ends as the signal would have.
void on_stop_signal(int signal)
{
    discard_open_atomic_files();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

int run(int argc, char** argv)
{
    CLI::App cli("Draws baked scenes with real-time techniques, on a GPU or without one.", "atrium");
    cli.set_version_flag("--version", "atrium " ATRIUM_VERSION);
    cli.require_subcommand(1);
    cli.footer("Example:\n  atrium render sponza.atrium --eye -11.5,1.7,-0.4 --target 10,3.5,-0.4 -o sponza.png\n\n"
               "`atrium COMMAND --help` tells more.");
    const std::array commands{
        std::pair{"render", app::add_render_command(cli)},   std::pair{"view", app::add_view_command(cli)},
        std::pair{"bench", app::add_bench_command(cli)},     std::pair{"upscale", app::add_upscale_command(cli)},
        std::pair{"compare", app::add_compare_command(cli)}, std::pair{"settings", app::add_settings_command(cli)},
        std::pair{"devices", app::add_devices_command(cli)},
    };
    for (CLI::App* command : cli.get_subcommands({})) {
        command->add_flag_callback(
            "--quiet", [] { set_log_level(LogLevel::quiet); }, "say only warnings and errors");
        command->add_flag_callback(
            "--verbose", [] { set_log_level(LogLevel::verbose); }, "say more");
    }
    if (const auto answered = app::parse_command_line(cli, argc, argv)) return *answered;
    for (const auto& [name, command] : commands) {
        if (cli.got_subcommand(name)) return command();
    }
    return static_cast<int>(ExitCode::internal);
}

} // namespace

int main(int argc, char** argv)
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, on_stop_signal);
    try {
        return run(argc, argv);
    } catch (const Error& error) {
        std::fprintf(stderr, "atrium: %s\n", error.text().c_str());
        return static_cast<int>(error.code());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "atrium: out of memory\n  next:  use a smaller scene or --size\n");
        return static_cast<int>(ExitCode::environment);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "atrium: internal error: %s\n  next:  please report this with the command line\n",
                     error.what());
        return static_cast<int>(ExitCode::internal);
    }
}
