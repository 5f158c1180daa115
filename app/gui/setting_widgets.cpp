#include "app/gui/setting_widgets.hpp"

#include "app/gui/text_field.hpp"
#include "renderer/core/text_value.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

/// ImGui takes no more than half of what the types hold.
template <class T>
struct Limits {
    T min, max;
};
template <class T>
Limits<T> slider_limits(const Range& range)
{
    constexpr double most = static_cast<double>(std::numeric_limits<T>::max()) / 2;
    const auto limit = [&](float x) { return static_cast<T>(std::clamp(static_cast<double>(x), -most, most)); };
    return {limit(range.min), limit(range.max)};
}

ImGuiSliderFlags slider_flags(const Range& range)
{
    return ImGuiSliderFlags_AlwaysClamp | (is_logarithmic(range) ? ImGuiSliderFlags_Logarithmic : 0);
}

/// The number and its unit, where that leaves room for the number.
std::string format_with_unit(const char* number, const std::string& unit)
{
    std::string format = number;
    if (unit.empty() || ImGui::CalcTextSize(unit.c_str()).x > 0.6f * ImGui::CalcItemWidth()) return format;
    format += ' ';
    for (const char c : unit) format += c == '%' ? "%%" : std::string(1, c);
    return format;
}

bool assign(const Setting& s, const std::string& text)
{
    return text != s.get() && !s.set_text(text);
}

bool draw_value(const Setting& s, const bool* field)
{
    bool value = *field;
    return ImGui::Checkbox("##value", &value) && assign(s, to_text(value));
}

bool draw_value(const Setting& s, const int* field)
{
    int value = *field;
    const std::string format = format_with_unit("%d", s.unit);
    if (!s.range) return ImGui::DragInt("##value", &value, 0.2f, 0, 0, format.c_str()) && assign(s, to_text(value));
    const auto limits = slider_limits<int>(*s.range);
    return ImGui::SliderInt("##value", &value, limits.min, limits.max, format.c_str(), slider_flags(*s.range)) &&
           assign(s, to_text(std::clamp(value, limits.min, limits.max)));
}

/// Per pixel of a drag: a hundredth of the value, and of 1 near zero.
float drag_speed(float value)
{
    return 0.01f * std::max(1.0f, std::abs(value));
}

bool draw_value(const Setting& s, const float* field)
{
    float value = *field;
    const std::string format = format_with_unit("%.4g", s.unit);
    if (!s.range) {
        return ImGui::DragFloat("##value", &value, drag_speed(value), 0, 0, format.c_str()) &&
               assign(s, to_text(value));
    }
    const auto limits = slider_limits<float>(*s.range);
    return ImGui::SliderFloat("##value", &value, limits.min, limits.max, format.c_str(), slider_flags(*s.range)) &&
           assign(s, to_text(std::clamp(value, limits.min, limits.max)));
}

bool draw_value(const Setting& s, const vec3* field)
{
    vec3 value = *field;
    bool changed = false;
    if (is_color(s)) {
        changed = ImGui::ColorEdit3(
            "##value", &value.x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoOptions);
    } else {
        const Range range = s.range.value_or(Range{0, 0}); // 0, 0: as far as one likes
        const float length = std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
        changed = ImGui::DragFloat3("##value", &value.x, drag_speed(length), range.min, range.max, "%.4g",
                                    s.range ? ImGuiSliderFlags_AlwaysClamp : ImGuiSliderFlags_None);
    }
    if (s.range) value = glm::clamp(value, vec3(s.range->min), vec3(s.range->max));
    return changed && assign(s, to_text(value));
}

/// One of the setting's values.
bool draw_choice(const Setting& s)
{
    const auto shown = [](const std::string& text) { return text.empty() ? "none" : text.c_str(); };
    const std::string present = s.get();
    bool changed = false;
    if (!ImGui::BeginCombo("##value", shown(present))) return false;
    for (const std::string& name : s.values) {
        if (ImGui::Selectable(shown(name), name == present)) changed = assign(s, name);
        if (name == present) ImGui::SetItemDefaultFocus();
    }
    ImGui::EndCombo();
    return changed;
}

bool draw_value(const Setting& s, const EnumField& /*field*/)
{
    return draw_choice(s);
}

bool draw_value(const Setting& s, const std::string* field)
{
    if (!s.values.empty()) return draw_choice(s);
    std::string value = *field;
    return draw_text_field("##value", value) && assign(s, value);
}

void draw_tooltip(const std::string& text)
{
    if (!ImGui::IsItemHovered() || ImGui::IsAnyItemActive()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(20.0f * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool draw_reset(const Setting& s, bool is_cpu)
{
    if (s.is_default(is_cpu)) return false;
    const std::string& text = default_of(s, is_cpu);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight());
    const bool pressed = ImGui::ArrowButton("##reset", ImGuiDir_Left);
    draw_tooltip(fmt::format("Back to {}", text.empty() ? "no text" : text));
    return pressed && !s.set_text(text);
}

/// Settings from `begin` on that stand under the same heading.
std::size_t end_of_group(const std::vector<Setting>& all, std::size_t begin)
{
    std::size_t end = begin;
    while (end < all.size() && all[end].group_title == all[begin].group_title) ++end;
    return end;
}

std::string lower(std::string_view text)
{
    std::string out(text);
    for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

} // namespace

bool draw_setting(const Setting& s, bool is_cpu)
{
    const bool is_vector = std::holds_alternative<vec3*>(s.field);
    std::string label = label_of(s);
    if (is_vector && !s.unit.empty()) label += fmt::format(" ({})", s.unit); // beside each number there is no room

    ImGui::PushID(s.key.c_str());
    ImGui::BeginGroup();
    const float width =
        ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - ImGui::GetStyle().ItemSpacing.x; // for the button
    const float column = is_vector ? 0.0f : std::floor(0.44f * width);
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    if (!is_vector && ImGui::CalcTextSize(label.c_str()).x < column) {
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + column);
        ImGui::SetNextItemWidth(width - column);
    } else {
        ImGui::SetNextItemWidth(width);
    }
    bool changed = std::visit([&](const auto& field) { return draw_value(s, field); }, s.field);
    ImGui::EndGroup();
    draw_tooltip(tooltip_of(s, is_cpu));
    changed = draw_reset(s, is_cpu) || changed;
    ImGui::PopID();
    return changed;
}

DrawnSettings draw_settings(const SettingList& list, std::string_view filter, bool is_cpu, Headings headings)
{
    const bool filtered = filter.find_first_not_of(' ') != std::string_view::npos;
    DrawnSettings drawn;
    bool any = false;
    const std::vector<Setting>& all = list.all();
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        end = end_of_group(all, begin);
        std::vector<const Setting*> shown;
        int differing = 0;
        for (std::size_t i = begin; i < end; ++i) {
            if (matches_filter(all[i], filter)) shown.push_back(&all[i]);
            differing += all[i].is_default(is_cpu) ? 0 : 1;
        }
        if (shown.empty()) continue;
        any = true;
        if (filtered) {
            ImGui::TextDisabled("%s", all[begin].group_title.c_str());
        } else {
            if (headings != Headings::as_they_are) ImGui::SetNextItemOpen(headings == Headings::open);
            const std::string mark = differing == 0 ? "" : fmt::format("  ({} changed)", differing);
            const std::string title = fmt::format("{}{}###{}", all[begin].group_title, mark, all[begin].key);
            if (!ImGui::CollapsingHeader(title.c_str())) continue;
        }
        for (const Setting* s : shown) {
            drawn.changed = draw_setting(*s, is_cpu) || drawn.changed;
            ++drawn.count;
        }
    }
    if (!any) ImGui::TextDisabled("No setting matches.");
    return drawn;
}

bool contains_words(std::string_view whole, std::string_view filter)
{
    const std::string text = lower(whole), wanted = lower(filter);
    for (std::size_t begin = 0; begin < wanted.size();) {
        const std::size_t end = std::min(wanted.find(' ', begin), wanted.size());
        if (text.find(wanted.substr(begin, end - begin)) == std::string::npos) return false;
        begin = end + 1;
    }
    return true;
}

bool matches_filter(const Setting& s, std::string_view filter)
{
    return contains_words(fmt::format("{} {} {} {}", s.key, label_of(s), s.group_title, s.help), filter);
}

std::string label_of(const Setting& s)
{
    std::string label = s.key.substr(s.key.rfind('.') + 1); // npos + 1 is 0
    std::replace(label.begin(), label.end(), '_', ' ');
    return label;
}

std::string tooltip_of(const Setting& s, bool is_cpu)
{
    const std::string unit = s.unit.empty() ? "" : " " + s.unit;
    const std::string& standard = default_of(s, is_cpu);
    std::string out = fmt::format("{}\n{}", s.help, s.key);
    if (s.range)
        out += fmt::format("\nfrom {} to {}{}", s.range->min, s.range->max, unit);
    else if (!s.unit.empty())
        out += fmt::format("\nin {}", s.unit);
    if (!s.values.empty()) out += fmt::format("\none of {}", fmt::join(s.values, ", "));
    return out + fmt::format("\ndefault {}{}", standard.empty() ? "no text" : standard, unit);
}

bool is_color(const Setting& s)
{
    if (!std::holds_alternative<vec3*>(s.field)) return false;
    return lower(s.key).find("color") != std::string::npos || s.unit.starts_with("nit");
}

bool is_logarithmic(const Range& range)
{
    // From 0 on, decades are counted from 1.
    const float least = range.min > 0.0f ? range.min : 1.0f;
    return std::max(std::abs(range.min), std::abs(range.max)) >= 1000.0f * least;
}

const std::string& default_of(const Setting& s, bool is_cpu)
{
    return is_cpu ? s.cpu_default : s.default_text;
}

} // namespace atrium::gui
