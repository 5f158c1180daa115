// Settings as TOML, JSON and Markdown.

#include "renderer/core/setting.hpp"

#include "renderer/core/text_value.hpp"

#include <charconv>
#include <cstdint>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace atrium {
namespace {

using Json = nlohmann::ordered_json;

/// The double that prints as shortly as the float: 0.6, not 0.6000000238418579.
Json number(float value)
{
    const std::string text = to_text(value);
    double out = 0;
    std::from_chars(text.data(), text.data() + text.size(), out);
    return out;
}

/// `text` is a value of the setting, as get() gives it.
Json typed(const Setting& s, const std::string& text)
{
    if (std::holds_alternative<bool*>(s.field)) return *parse_bool(text);
    if (std::holds_alternative<int*>(s.field)) return *parse_int(text);
    if (std::holds_alternative<float*>(s.field)) return number(*parse_float(text));
    if (std::holds_alternative<vec3*>(s.field)) {
        const vec3 v = *parse_vec3(text);
        return Json::array({number(v.x), number(v.y), number(v.z)});
    }
    return text;
}

/// JSON's numbers, booleans, arrays and strings are TOML's too: nlohmann prints whole doubles as "1.0", and escapes
/// only what TOML's basic strings escape alike.
std::string toml_value(const Setting& s, const std::string& text)
{
    return typed(s, text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string allowed(const Setting& s)
{
    if (s.range) return fmt::format("{} to {}", s.range->min, s.range->max);
    if (!s.values.empty()) return fmt::format("{}", fmt::join(s.values, ", "));
    return std::holds_alternative<bool*>(s.field) ? "on, off" : "";
}

std::string keys_text(const Keys& keys)
{
    return *keys.less ? fmt::format("{}, {}", keys.more, keys.less) : keys.more;
}

/// A cell must not end the table's row or column.
std::string cell(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        if (c == '|') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out;
}

} // namespace

std::string SettingList::to_toml() const
{
    std::string out = "[settings]\n";
    const std::string* title = nullptr;
    for (const Setting& s : settings_) {
        if (title == nullptr || *title != s.group_title) out += fmt::format("\n# ---- {}\n", s.group_title);
        title = &s.group_title;
        std::string comment = s.help;
        if (const std::string values = allowed(s); !values.empty()) comment += fmt::format("; {}", values);
        if (!s.unit.empty()) comment += fmt::format(" ({})", s.unit);
        if (s.cpu_default != s.default_text) {
            comment += fmt::format("; on a CPU device {}", toml_value(s, s.cpu_default));
        }
        out += fmt::format("# {}\n{} = {}\n", comment, s.key, toml_value(s, s.get()));
    }
    return out;
}

std::string SettingList::to_json() const
{
    Json out = Json::array();
    for (const Setting& s : settings_) {
        Json range, values;
        if (s.range && std::holds_alternative<int*>(s.field)) {
            range = Json::array({static_cast<std::int64_t>(s.range->min), static_cast<std::int64_t>(s.range->max)});
        } else if (s.range) {
            range = Json::array({number(s.range->min), number(s.range->max)});
        }
        if (!s.values.empty()) values = s.values;
        out.push_back({{"key", s.key},
                       {"type", s.type()},
                       {"unit", s.unit},
                       {"range", range},
                       {"values", values},
                       {"default", typed(s, s.default_text)},
                       {"cpu_default", typed(s, s.cpu_default)},
                       {"help", s.help}});
    }
    return out.dump(2) + "\n";
}

std::string SettingList::to_markdown() const
{
    std::string out;
    const std::string* title = nullptr;
    for (const Setting& s : settings_) {
        if (title == nullptr || *title != s.group_title) {
            out += fmt::format(
                "{}## {}\n\n| key | type | default | on a CPU | allowed | unit | meaning | in the window |\n"
                "|---|---|---|---|---|---|---|---|\n",
                out.empty() ? "" : "\n", s.group_title);
        }
        title = &s.group_title;
        const std::string cpu = s.cpu_default == s.default_text ? "" : fmt::format("`{}`", s.cpu_default);
        out += fmt::format("| `{}` | {} | `{}` | {} | {} | {} | {} | {} |\n", s.key, s.type(), cell(s.default_text),
                           cell(cpu), cell(allowed(s)), cell(s.unit), cell(s.help), cell(keys_text(s.keys)));
    }
    return out;
}

} // namespace atrium
