#include "assetconv/command_line.hpp"

#include "renderer/core/error.hpp"
#include "renderer/core/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace atrium {
namespace {

std::vector<std::string> option_names(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

} // namespace

void refuse_choice(const std::string& option, const std::string& typed, const std::vector<std::string>& names)
{
    throw Error(ExitCode::usage, fmt::format("unknown value \"{}\"", typed), option,
                fmt::format("it takes one of: {}", fmt::join(names, ", ")),
                did_you_mean(typed, names, "choose one of them"));
}

void refuse_extras(const CLI::App& command, const std::string& program)
{
    const std::vector<std::string> extras = command.remaining();
    if (extras.empty()) return;
    const auto option =
        std::find_if(extras.begin(), extras.end(), [](const std::string& e) { return e.size() > 1 && e[0] == '-'; });
    const std::string help = fmt::format("`{} {} --help` lists the options", program, command.get_name());
    if (option == extras.end()) {
        throw Error(ExitCode::usage, fmt::format("unexpected argument \"{}\"", extras.front()), "command line",
                    "every other argument has its place already", help);
    }
    const std::string typed = option->substr(0, option->find('='));
    const std::string nearest = did_you_mean(typed, option_names(command));
    throw Error(ExitCode::usage, fmt::format("unknown option \"{}\"", typed), "command line", "",
                nearest + (nearest.empty() ? "" : " ") + help);
}

void check_range(const std::string& option, double value, double low, double high)
{
    if (value >= low && value <= high) return;
    throw Error(ExitCode::usage, fmt::format("value {} out of range", value), option,
                fmt::format("it must lie between {} and {}", low, high), "choose a value in that range");
}

} // namespace atrium
