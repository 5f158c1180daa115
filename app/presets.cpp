#include "app/presets.hpp"

#include "app/embedded_presets.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/nearest_name.hpp"

#include <fmt/format.h>

namespace atrium::app {

std::vector<std::string> preset_names()
{
    std::vector<std::string> names;
    for (const auto& [name, text] : embedded_presets()) names.emplace_back(name);
    return names;
}

std::vector<SettingText> preset_settings(const std::string& name)
{
    for (const auto& [known, text] : embedded_presets()) {
        if (name == known) return parse_settings(text, fmt::format("preset {}", name));
    }
    throw Error(ExitCode::usage, fmt::format("no preset is called \"{}\"", name), "--preset",
                did_you_mean(name, preset_names()), "presets: " + fmt::format("{}", fmt::join(preset_names(), ", ")));
}

} // namespace atrium::app
