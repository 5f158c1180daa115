#include "app/gui/notice.hpp"

#include "app/gui/panels.hpp"

#include <imgui/imgui.h>

#include <algorithm>

namespace atrium::gui {

bool draw_notice(Corner corner, const std::string& text, const char* button, float scale)
{
    constexpr float from_edge = 8, narrowest = 280, widest = 520;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float margin = from_edge * scale;
    const float beside = std::clamp(display.x - panel_end * scale - margin, narrowest * scale, widest * scale);
    const bool top = corner == Corner::top_right;
    ImGui::SetNextWindowPos({display.x - margin, top ? margin : display.y - margin}, ImGuiCond_Always,
                            {1, top ? 0.0f : 1.0f});
    ImGui::SetNextWindowSize({std::min(beside, display.x - 2 * margin), 0});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                       ImGuiWindowFlags_NoNav;
    bool pressed = false;
    if (ImGui::Begin(top ? "##notice above" : "##notice below", nullptr, flags)) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopTextWrapPos();
        pressed = button && ImGui::Button(button);
    }
    ImGui::End();
    return pressed;
}

} // namespace atrium::gui
