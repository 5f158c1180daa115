#include "app/view/key_bindings.hpp"

#include "app/view/key_names.hpp"
#include "renderer/core/nearest_name.hpp"
#include "renderer/scene/toml_reader.hpp"
#include "renderer/settings.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace atrium::app {
namespace {

/// Shift does not count: it makes flying faster.
constexpr int counted_mods = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;

KeyPress read_key(const std::string& name, bool held, const toml::node& value, const std::string& where)
{
    const auto text = value.value_exact<std::string>();
    if (!text) {
        throw Error(ExitCode::input, fmt::format("bad key of \"{}\"", name), where,
                    fmt::format("expected a string, found {}", kind_of(value)), "give the name of a key");
    }
    const auto key = parse_key(*text);
    if (!key) {
        const std::string bare = text->substr(text->rfind('+') + 1); // npos + 1 is 0
        throw Error(ExitCode::input, fmt::format("no key is called \"{}\"", *text), where,
                    suggest_name(bare, key_names()), "keys are named as in the help (H)");
    }
    if (held && key->mods != 0) {
        throw Error(ExitCode::input, fmt::format("\"{}\" cannot be the key of \"{}\"", *text, name), where,
                    "it acts as long as its key is held, and Ctrl is for the mouse then",
                    "give a key without Ctrl or Alt");
    }
    return *key;
}

SettingList all_settings()
{
    Settings settings;
    SettingList list;
    describe(list, settings);
    return list; // of which names and keys are read alone
}

} // namespace

KeyBindings::KeyBindings() : KeyBindings(all_settings()) {}

KeyBindings::KeyBindings(const SettingList& settings)
{
    for (const ActionInfo& info : all_actions()) all_.push_back({info.name, info.help, info.key, {}, info.action, {}});
    for (const gui::SettingStep& step : gui::setting_steps(settings)) {
        const auto key = parse_key(step.key);
        if (!key && !step.key.empty())
            throw std::logic_error(fmt::format("the description of {} names no key: {}", step.setting, step.key));
        all_.push_back({step.name, step.help, key.value_or(KeyPress{}), {}, Action::none, step});
    }
    bind({});
}

void KeyBindings::bind(const std::vector<Line>& lines)
{
    for (Bindable& b : all_) b.key = b.by_default;
    for (const Line& line : lines) all_[line.index].key = line.key;
}

std::size_t KeyBindings::find(const std::string& name, const std::string& where) const
{
    std::vector<std::string> names;
    for (const Bindable& b : all_) {
        if (b.name == name) return names.size();
        names.push_back(b.name);
    }
    throw Error(ExitCode::input, fmt::format("no action is called \"{}\"", name), where, suggest_name(name, names),
                "in the help (H), the mouse shows the name of each; settings are called as in \"atrium settings\", "
                "numbers with .more or .less behind");
}

std::optional<std::size_t> KeyBindings::other_on_same_key(std::size_t index) const
{
    if (all_[index].key == KeyPress{}) return std::nullopt;
    for (std::size_t i = 0; i < all_.size(); ++i) {
        if (i != index && all_[i].key == all_[index].key) return i;
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
    for (const TomlEntry& entry : dotted_entries(table)) {
        const std::string where = where_in(file, entry.source);
        try {
            const std::size_t index = find(entry.key, where);
            const Bindable& b = all_[index];
            lines.push_back({index, read_key(b.name, is_held(b.action), *entry.node, where), where});
        } catch (const Error& error) {
            errors.push_back(error);
        }
    }
    // A line does not count whose key has another action, of two such lines the later one. The default that its action
    // goes back to may in turn be taken, so all are looked through again.
    for (;;) {
        bind(lines);
        const auto line = std::find_if(lines.rbegin(), lines.rend(),
                                       [&](const Line& l) { return other_on_same_key(l.index).has_value(); });
        if (line == lines.rend()) return errors;
        errors.emplace_back(
            ExitCode::input, fmt::format("two actions are on the key \"{}\"", name_of(line->key)), line->where,
            fmt::format("\"{}\" and \"{}\"", all_[line->index].name, all_[*other_on_same_key(line->index)].name),
            "give each a key of its own");
        lines.erase(std::next(line).base());
    }
}

const KeyBindings::Bindable* KeyBindings::bound_to(const KeyPress& press) const
{
    const KeyPress counted{press.key, press.mods & counted_mods};
    const auto found = std::find_if(all_.begin(), all_.end(),
                                    [&](const Bindable& b) { return b.key == counted && b.key != KeyPress{}; });
    return found == all_.end() ? nullptr : &*found;
}

Action KeyBindings::action_of(const KeyPress& press) const
{
    const Bindable* found = bound_to(press);
    return found == nullptr || is_held(found->action) ? Action::none : found->action;
}

const gui::SettingStep* KeyBindings::step_of(const KeyPress& press) const
{
    const Bindable* found = bound_to(press);
    return found == nullptr || found->action != Action::none ? nullptr : &found->step;
}

KeyPress KeyBindings::key_of(Action action) const
{
    return std::find_if(all_.begin(), all_.end(), [&](const Bindable& b) { return b.action == action; })->key;
}

std::vector<gui::KeyHelp> KeyBindings::help() const
{
    std::vector<gui::KeyHelp> out{
        {"Drag", "turn the view", ""},
        {"Click", "with the tab Materials open: select the material", ""},
        {"Wheel", "speed", ""},
        {"Shift", "faster", ""},
        {"Ctrl+drag", "move the selected light (Shift: along the view)", ""},
    };
    for (const Bindable& b : all_) {
        if (b.key != KeyPress{}) out.push_back({name_of(b.key), b.help, b.name});
    }
    return out;
}

} // namespace atrium::app
