#pragma once
// The commands of `atrium`. Each adds its options to the command line and returns what to run when it was chosen.

#include <functional>

namespace CLI {
class App;
}

namespace atrium::app {

/// Runs the command; returns the program's exit code. Throws Error.
using Run = std::function<int()>;

[[nodiscard]] Run add_render_command(CLI::App& app);
[[nodiscard]] Run add_view_command(CLI::App& app);
[[nodiscard]] Run add_bench_command(CLI::App& app);
[[nodiscard]] Run add_compare_command(CLI::App& app);
[[nodiscard]] Run add_upscale_command(CLI::App& app);
[[nodiscard]] Run add_settings_command(CLI::App& app);
[[nodiscard]] Run add_devices_command(CLI::App& app);

} // namespace atrium::app
