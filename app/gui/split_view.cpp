#include "app/gui/split_view.hpp"

#include "app/gui/controls.hpp"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <utility>

namespace atrium::gui {
namespace {

constexpr float grip_width = 14, grip_height = 36, margin = 8; ///< x scale

/// Beside the divider at `x`, at its left or right, but within the window.
void draw_label(float x, bool left, float scale, const char* id, const std::string& text)
{
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoBringToFrontOnFocus;
    const float width = ImGui::CalcTextSize(text.c_str()).x + 2 * ImGui::GetStyle().WindowPadding.x;
    const float from = left ? x - margin * scale - width : x + margin * scale;
    const float most = ImGui::GetIO().DisplaySize.x - width - margin * scale;
    ImGui::SetNextWindowPos({std::clamp(from, margin * scale, std::max(most, margin * scale)), margin * scale});
    if (ImGui::Begin(id, nullptr, flags)) ImGui::TextUnformatted(text.c_str());
    ImGui::End();
}

std::string side_text(const char* side, double ms)
{
    return ms > 0 ? fmt::format("{}  {:.0f} ms", side, ms) : side;
}

} // namespace

std::vector<std::string> differences(const Settings& first, const Settings& second)
{
    if (same_settings(first, second)) return {};
    Settings a = first, b = second; // which lists are bound to
    SettingList left, right;
    describe(left, a);
    describe(right, b);
    std::vector<std::string> out;
    for (std::size_t i = 0; i < left.all().size(); ++i) {
        const Setting &before = left.all()[i], &after = right.all()[i];
        if (before.value() != after.value())
            out.push_back(fmt::format("{}: {} | {}", before.key, before.get(), after.get()));
    }
    return out;
}

void draw_split_controls(ViewModel& model, float scale)
{
    if (!model.split) {
        if (flowing_button("split view", false)) {
            const float width = ImGui::GetIO().DisplaySize.x, left = std::min(panel_end * scale, 0.5f * width);
            model.split = Split{model.settings, 0.5f * (left + width) / width}; // in the middle of what is free
        }
        tooltip("Left of a line the settings as they are now, right of it as you change them");
        return;
    }
    if (flowing_button("one view", true)) {
        model.split.reset();
        return;
    }
    tooltip("The right side alone");
    if (flowing_button("swap A and B", false)) std::swap(model.settings, model.split->other);
    if (flowing_button("A like B", false)) model.split->other = model.settings;
    const std::vector<std::string> all = differences(model.split->other, model.settings);
    if (all.empty()) wrapped("A and B are the same: what you change is changed in B.");
    for (const std::string& line : all) wrapped(line);
}

void draw_divider(ViewModel& model, const FrameFacts& facts, float scale)
{
    if (!model.split) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float x = std::clamp(model.split->divider, 0.0f, 1.0f) * display.x;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddLine({x, 0}, {x, display.y}, IM_COL32(0, 0, 0, 160), 3 * scale);
    list.AddLine({x, 0}, {x, display.y}, IM_COL32(255, 255, 255, 230), scale);

    const float width = grip_width * scale, height = grip_height * scale;
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::SetNextWindowPos({x - 0.5f * width, 0});
    ImGui::SetNextWindowSize({width, display.y});
    if (ImGui::Begin("divider", nullptr, flags)) {
        ImGui::InvisibleButton("grip", {width, display.y});
        const bool held = ImGui::IsItemActive();
        if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        if (held) model.split->divider = std::clamp(ImGui::GetMousePos().x / display.x, 0.02f, 0.98f);
        const ImVec2 from{x - 0.5f * width, 0.5f * (display.y - height)};
        const ImU32 color = ImGui::GetColorU32(held ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab);
        ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + width, from.y + height}, color, 0.5f * width);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    draw_label(x, true, scale, "side A", side_text("A", facts.side_ms[0]));
    draw_label(x, false, scale, "side B", side_text("B", facts.side_ms[1]));
}

} // namespace atrium::gui
