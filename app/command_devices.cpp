// `atrium devices`: every Vulkan device, and every reason why one is not suitable.

#include "app/commands.hpp"
#include "renderer/core/error.hpp"
#include "renderer/gpu/instance.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace atrium::app {
namespace {

int list()
{
    const gpu::Instance instance(false);
    bool any = false;
    for (const gpu::DeviceReport& report : gpu::list_devices(instance)) {
        any = any || report.refusals.empty();
        fmt::print("{}  {} ({}){}\n", report.index, report.name, report.type,
                   report.refusals.empty() ? "" : "  not suitable");
        if (!report.driver.empty()) fmt::print("     driver: {}\n", report.driver);
        for (const std::string& reason : report.refusals) fmt::print("     refused: {}\n", reason);
        for (const std::string& absent : report.absent_optionals) fmt::print("     without {}\n", absent);
    }
    if (any) return 0;
    static_cast<void>(gpu::choose_device(instance, "")); // throws the message with every reason
    return static_cast<int>(ExitCode::environment);
}

} // namespace

Run add_devices_command(CLI::App& app)
{
    CLI::App* command = app.add_subcommand("devices", "list the Vulkan devices, and why one is not suitable");
    command->footer("Example:\n  atrium devices");
    return list;
}

} // namespace atrium::app
