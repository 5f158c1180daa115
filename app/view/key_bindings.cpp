#include "app/view/key_bindings.hpp"

#include "app/view/key_names.hpp"
#include "renderer/core/nearest_name.hpp"
#include "renderer/scene/toml_reader.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace atrium::app {
namespace {

/// Shift does not count: it makes flying faster.
constexpr int counted_mods = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;

std::size_t find_action(const std::string& name, const std::string& where)
{
    std::vector<std::string> names;
    for (const ActionInfo& info : all_actions()) {
        if (info.name == name) return names.size();
        names.emplace_back(info.name);
    }
    throw Error(ExitCode::input, fmt::format("no action is called \"{}\"", name), where,
                fmt::format("did you mean \"{}\"?", nearest_name(name, names)),
                "in the help (H), the mouse shows the name of each");
}

KeyPress find_key(const ActionInfo& info, const toml::node& value, const std::string& where)
{
    const auto text = value.value_exact<std::string>();
    if (!text) {
        throw Error(ExitCode::input, fmt::format("bad key of \"{}\"", info.name), where,
                    fmt::format("expected a string, found {}", kind_of(value)), "give the name of a key");
    }
    const auto key = parse_key(*text);
    if (!key) {
        const std::string bare = text->substr(text->rfind('+') + 1); // npos + 1 is 0
        throw Error(ExitCode::input, fmt::format("no key is called \"{}\"", *text), where,
                    fmt::format("did you mean \"{}\"?", nearest_name(bare, key_names())),
                    "keys are named as in the help (H)");
    }
    if (is_held(info.action) && key->mods != 0) {
        throw Error(ExitCode::input, fmt::format("\"{}\" cannot be the key of \"{}\"", *text, info.name), where,
                    "it acts as long as its key is held, and Ctrl is for the mouse then",
                    "give a key without Ctrl or Alt");
    }
    return *key;
}

} // namespace

KeyBindings::KeyBindings()
{
    bind({});
}

void KeyBindings::bind(const std::vector<Line>& lines)
{
    keys_.clear();
    for (const ActionInfo& info : all_actions()) keys_.push_back(info.key);
    for (const Line& line : lines) keys_[line.action] = line.key;
}

std::optional<std::size_t> KeyBindings::other_on_same_key(std::size_t action) const
{
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        if (i != action && keys_[i] == keys_[action]) return i;
    }
    return std::nullopt;
}

std::vector<Error> KeyBindings::read(const std::filesystem::path& file)
{
    std::vector<Error> errors;
    std::vector<Line> lines;
    toml::table table;
    try {
        table = parse_toml(file);
    } catch (const Error& error) {
        return {error};
    }
    for (const TomlEntry& entry : in_file_order(table)) {
        const std::string where = where_in(file, entry.source);
        try {
            const std::size_t action = find_action(entry.key, where);
            lines.push_back({action, find_key(all_actions()[action], *entry.node, where), where});
        } catch (const Error& error) {
            errors.push_back(error);
        }
    }
    // A line does not count whose key has another action, of two such lines the later one. The default that its action
    // goes back to may in turn be taken, so all are looked through again.
    for (;;) {
        bind(lines);
        const auto line = std::find_if(lines.rbegin(), lines.rend(),
                                       [&](const Line& l) { return other_on_same_key(l.action).has_value(); });
        if (line == lines.rend()) return errors;
        errors.emplace_back(ExitCode::input, fmt::format("two actions are on the key \"{}\"", name_of(line->key)),
                            line->where,
                            fmt::format("\"{}\" and \"{}\"", all_actions()[line->action].name,
                                        all_actions()[*other_on_same_key(line->action)].name),
                            "give each a key of its own");
        lines.erase(std::next(line).base());
    }
}

Action KeyBindings::action_of(const KeyPress& press) const
{
    const auto found = std::find(keys_.begin(), keys_.end(), KeyPress{press.key, press.mods & counted_mods});
    if (found == keys_.end()) return Action::none;
    const Action action = all_actions()[static_cast<std::size_t>(found - keys_.begin())].action;
    return is_held(action) ? Action::none : action;
}

KeyPress KeyBindings::key_of(Action action) const
{
    const auto actions = all_actions();
    const auto found =
        std::find_if(actions.begin(), actions.end(), [&](const ActionInfo& info) { return info.action == action; });
    return keys_.at(static_cast<std::size_t>(found - actions.begin()));
}

std::vector<gui::KeyHelp> KeyBindings::help() const
{
    std::vector<gui::KeyHelp> out{
        {"Drag", "turn the view", ""},
        {"Wheel", "speed", ""},
        {"Shift", "faster", ""},
        {"Ctrl+drag", "move the selected light (Shift: along the view)", ""},
    };
    for (std::size_t i = 0; i < keys_.size(); ++i)
        out.push_back({name_of(keys_[i]), all_actions()[i].help, all_actions()[i].name});
    return out;
}

} // namespace atrium::app
