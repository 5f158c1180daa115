#include "app/toml_text.hpp"

#include <fmt/format.h>

namespace atrium::app {

std::string toml_string(std::string_view text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + "\"";
}

std::string differing_toml(const SettingList& list)
{
    std::string out = "[settings]\n";
    for (const auto& [key, text] : list.differing()) out += fmt::format("{} = {}\n", key, toml_string(text));
    return out;
}

} // namespace atrium::app
