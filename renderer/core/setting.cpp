#include "renderer/core/setting.hpp"

#include "renderer/core/nearest_name.hpp"
#include "renderer/core/text_value.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace atrium {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>; // clang 14 does not deduce it by itself

std::string range_text(const Setting& s)
{
    return fmt::format("{} to {}{}{}", s.range->min, s.range->max, s.unit.empty() ? "" : " ", s.unit);
}

using Refusal = Setting::Refusal;

Refusal not_a(const Setting& s, std::string_view expected)
{
    std::string advice = fmt::format("give {}", expected);
    if (s.range) advice += fmt::format(", {}", range_text(s));
    return {fmt::format("it is not {}", expected), std::move(advice)};
}

template <class T>
std::optional<Refusal> assign(const Setting& s, T& field, const std::optional<T>& value, std::string_view expected)
{
    if (!value) return not_a(s, expected);
    bool in_range = true;
    if (s.range) {
        const auto check = [&](auto x) {
            in_range = in_range && static_cast<double>(x) >= static_cast<double>(s.range->min) &&
                       static_cast<double>(x) <= static_cast<double>(s.range->max);
        };
        if constexpr (std::is_same_v<T, vec3>) {
            for (int i = 0; i < 3; ++i) check((*value)[i]);
        } else {
            check(*value);
        }
    }
    if (!in_range) {
        return Refusal{fmt::format("the range is {}", range_text(s)),
                       fmt::format("give {} from {}", expected, range_text(s))};
    }
    field = *value;
    return std::nullopt;
}

std::optional<Refusal> assign_enum(const Setting& s, const EnumField& field, std::string_view text)
{
    for (std::size_t i = 0; i < s.values.size(); ++i) {
        if (s.values[i] != text) continue;
        field.set(field.value, static_cast<int>(i));
        return std::nullopt;
    }
    return Refusal{fmt::format("the values are {}", fmt::join(s.values, ", ")),
                   did_you_mean(text, s.values, "choose one of them")};
}

} // namespace

const char* Setting::type() const
{
    static constexpr const char* names[] = {"bool", "int", "float", "string", "vec3", "enum"};
    static_assert(std::size(names) == std::variant_size_v<decltype(field)>);
    return names[field.index()];
}

std::string Setting::get() const
{
    return std::visit(Overloaded{
                          [](const std::string* text) { return *text; },
                          [this](const EnumField& e) { return values.at(static_cast<std::size_t>(e.get(e.value))); },
                          [](const auto* value) { return to_text(*value); },
                      },
                      field);
}

Setting::Value Setting::value() const
{
    return std::visit(Overloaded{
                          [](const EnumField& e) { return Value(e.get(e.value)); },
                          [](const auto* value) { return Value(*value); },
                      },
                      field);
}

std::optional<Setting::Refusal> Setting::set_text(std::string_view text) const
{
    return std::visit(
        Overloaded{
            [&](bool* value) { return assign(*this, *value, parse_bool(text), "on, off, true or false"); },
            [&](int* value) { return assign(*this, *value, parse_int(text), "a whole number"); },
            [&](float* value) { return assign(*this, *value, parse_float(text), "a number"); },
            [&](vec3* value) { return assign(*this, *value, parse_vec3(text), "three numbers as x:y:z"); },
            [&](std::string* value) -> std::optional<Refusal> {
                *value = text;
                return std::nullopt;
            },
            [&](const EnumField& value) { return assign_enum(*this, value, text); },
        },
        field);
}

SettingList::SettingList(std::string noun, std::string hint) : noun_(std::move(noun)), hint_(std::move(hint)) {}

void SettingList::group(std::string_view prefix, std::string_view title)
{
    prefix_ = prefix.empty() ? std::string() : fmt::format("{}.", prefix);
    title_ = title;
}

void SettingList::add(std::string_view name, std::string_view help, Setting setting)
{
    setting.key = fmt::format("{}{}", prefix_, name);
    setting.group_title = title_;
    setting.help = help;
    for (const Setting& other : settings_) {
        // In TOML a key cannot be both a value and the table of others.
        if (other.key == setting.key || other.key.starts_with(setting.key + ".") ||
            setting.key.starts_with(other.key + ".")) {
            throw std::logic_error(fmt::format("the keys {} and {} collide", other.key, setting.key));
        }
    }
    setting.default_text = setting.get();
    if (setting.cpu_default.empty()) setting.cpu_default = setting.default_text;
    const auto take_default = [&](const std::string& text) {
        if (const auto refusal = setting.set_text(text)) {
            throw std::logic_error(fmt::format("the default {} of {}: {}", text, setting.key, refusal->why));
        }
        return setting.value();
    };
    setting.cpu_value = take_default(setting.cpu_default);
    setting.default_value = take_default(setting.default_text); // the default last: the field keeps it
    settings_.push_back(std::move(setting));
}

const Setting* SettingList::find(std::string_view key) const
{
    for (const Setting& setting : settings_) {
        if (setting.key == key) return &setting;
    }
    return nullptr;
}

void SettingList::offer(std::string_view key, std::vector<std::string> values)
{
    for (Setting& setting : settings_) {
        if (setting.key != key) continue;
        setting.values = std::move(values);
        return;
    }
}

std::string SettingList::nearest(std::string_view key) const
{
    std::vector<std::string> keys;
    keys.reserve(settings_.size());
    for (const Setting& setting : settings_) keys.push_back(setting.key);
    return nearest_name(key, keys);
}

void SettingList::set(std::string_view key, std::string_view text, ExitCode code, std::string_view where) const
{
    const Setting* setting = find(key);
    if (setting == nullptr) {
        std::vector<std::string> keys;
        for (const Setting& known : settings_) keys.push_back(known.key);
        const std::string suggested = suggest_name(key, keys);
        throw Error(code, fmt::format("unknown {} \"{}\"", noun_, key), std::string(where),
                    fmt::format("there is no {} of that name", noun_),
                    suggested + (suggested.empty() || hint_.empty() ? "" : " ") + hint_);
    }
    if (auto refusal = setting->set_text(text)) {
        throw Error(code, fmt::format("bad value \"{}\" for {} \"{}\"", text, noun_, key), std::string(where),
                    std::move(refusal->why), std::move(refusal->next));
    }
}

void SettingList::apply_cpu_defaults() const
{
    for (const Setting& setting : settings_) {
        if (setting.cpu_default != setting.default_text) (void)setting.set_text(setting.cpu_default);
    }
}

std::vector<std::pair<std::string, std::string>> SettingList::differing() const
{
    std::vector<std::pair<std::string, std::string>> out;
    for (const Setting& setting : settings_) {
        if (!setting.is_default(false)) out.emplace_back(setting.key, setting.get());
    }
    return out;
}

} // namespace atrium
