#include "app/gui/setting_step.hpp"

#include "renderer/core/text_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace atrium::gui {
namespace {

bool is_number(const Setting& s)
{
    return std::holds_alternative<int*>(s.field) || std::holds_alternative<float*>(s.field);
}

float stepped(const Setting& s, float value, bool less)
{
    constexpr float factor = 1.1f, share_of_range = 0.05f, from_zero = 0.01f;
    float next = 0;
    if (s.range && s.range->min < 0)
        next = value + (less ? -share_of_range : share_of_range) * (s.range->max - s.range->min);
    else if (value == 0)
        next = less ? 0 : from_zero * (s.range ? s.range->max : 1);
    else
        next = less ? value / factor : value * factor;
    if (std::holds_alternative<int*>(s.field))
        next = less ? std::min(std::round(next), value - 1) : std::max(std::round(next), value + 1);
    return s.range ? std::clamp(next, s.range->min, s.range->max) : next;
}

std::string next_value(const Setting& s)
{
    if (*s.keys.first) return s.get() == s.keys.first ? s.keys.second : s.keys.first;
    const auto at = std::find(s.values.begin(), s.values.end(), s.get());
    return at == s.values.end() || at + 1 == s.values.end() ? s.values.front() : *(at + 1);
}

} // namespace

std::vector<SettingStep> setting_steps(const SettingList& list)
{
    std::vector<SettingStep> out;
    for (const Setting& s : list.all()) {
        if (is_number(s)) {
            out.push_back({s.key + ".more", s.key, false, s.keys.more, fmt::format("{}: more", s.key)});
            out.push_back({s.key + ".less", s.key, true, s.keys.less, fmt::format("{}: less", s.key)});
        } else if (std::holds_alternative<bool*>(s.field)) {
            out.push_back({s.key, s.key, false, s.keys.more, fmt::format("{}: on and off", s.key)});
        } else if (std::holds_alternative<EnumField>(s.field)) {
            const std::string values = *s.keys.first ? fmt::format("{} and {}", s.keys.first, s.keys.second) : "next";
            out.push_back({s.key, s.key, false, s.keys.more, fmt::format("{}: {}", s.key, values)});
        }
    }
    return out;
}

void take_step(const SettingList& list, const SettingStep& step)
{
    const Setting* s = list.find(step.setting);
    if (s == nullptr) return;
    if (std::holds_alternative<bool*>(s->field)) {
        bool& on = *std::get<bool*>(s->field);
        on = !on;
    } else if (is_number(*s)) {
        const float value = *parse_float(s->get());
        static_cast<void>(s->set_text(to_text(stepped(*s, value, step.less))));
    } else {
        static_cast<void>(s->set_text(next_value(*s)));
    }
}

} // namespace atrium::gui
