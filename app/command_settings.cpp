// `atrium settings`: every setting, for people, for files and for programs.

#include "app/commands.hpp"
#include "app/json_output.hpp"
#include "renderer/settings.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>

namespace atrium::app {
namespace {

struct Options {
    bool toml = false, markdown = false;
    std::string json;
};

std::string to_lines(const SettingList& list)
{
    std::string out, title;
    for (const Setting& s : list.all()) {
        if (s.group_title != title) out += fmt::format("{}{}\n", title.empty() ? "" : "\n", s.group_title);
        title = s.group_title;
        std::string allowed;
        for (const std::string& value : s.values) allowed += (allowed.empty() ? "" : "|") + value;
        if (s.range) allowed = fmt::format("{} to {}", s.range->min, s.range->max);
        const std::string cpu = s.cpu_default != s.default_text ? fmt::format(" (CPU: {})", s.cpu_default) : "";
        out +=
            fmt::format("  {:<22} {}{}{}{}\n{:26}{}\n", s.key, s.default_text.empty() ? "\"\"" : s.default_text, cpu,
                        s.unit.empty() ? "" : " " + s.unit, allowed.empty() ? "" : "   [" + allowed + "]", "", s.help);
    }
    return out;
}

} // namespace

Run add_settings_command(CLI::App& app)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("settings", "list every setting with its range, default and meaning");
    command->add_flag("--toml", o->toml, "as a file for --config");
    command->add_flag("--markdown", o->markdown, "as docs/settings.md has them");
    command->add_option("--json", o->json, "as JSON to a file, or - for the terminal");
    command->footer("Example:\n  atrium settings --toml > my-settings.toml");
    return [o] {
        Settings settings;
        SettingList list;
        describe(list, settings);
        if (!o->json.empty())
            write_json_text(o->json, list.to_json());
        else
            fmt::print("{}", o->toml ? list.to_toml() : o->markdown ? list.to_markdown() : to_lines(list));
        return 0;
    };
}

} // namespace atrium::app
