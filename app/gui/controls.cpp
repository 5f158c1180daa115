#include "app/gui/controls.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace atrium::gui {

void wrapped(const std::string& text)
{
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

std::string grouped(std::uint64_t number)
{
    std::string out = fmt::format("{}", number);
    for (std::size_t i = out.size(); i > 3;) out.insert(i -= 3, 1, ' ');
    return out;
}

void tooltip(const char* text)
{
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

bool flowing_button(const char* label, bool first)
{
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcTextSize(label, nullptr, true).x + 2.0f * style.FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (!first && ImGui::GetItemRectMax().x + style.ItemSpacing.x + width < right) ImGui::SameLine();
    return ImGui::Button(label);
}

bool list_line(const std::string& text, bool selected)
{
    const float width = ImGui::GetContentRegionAvail().x;
    const bool clicked = ImGui::Selectable(fmt::format("{}###line", text).c_str(), selected,
                                           ImGuiSelectableFlags_DontClosePopups, {width, 0});
    if (ImGui::CalcTextSize(text.c_str()).x > width) tooltip(text.c_str());
    return clicked;
}

bool draw_list(const char* id, const std::vector<std::string>& lines, std::optional<std::size_t>& selected,
               const char* none)
{
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float shown = std::clamp(static_cast<float>(lines.size()), 1.0f, 8.0f);
    const float height = line * shown + 2.0f * ImGui::GetStyle().WindowPadding.y;
    bool clicked = false;
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    if (ImGui::BeginChild(id, {0, height}, true)) {
        if (lines.empty()) ImGui::TextDisabled("%s", none);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (list_line(lines[i], selected == i)) {
                selected = i;
                clicked = true;
            }
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    return clicked;
}

} // namespace atrium::gui
