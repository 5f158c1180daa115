#include "app/gui/text_field.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

namespace atrium::gui {

bool draw_text_field(const char* label, std::string& value)
{
    // Only one field has the keyboard. When a click elsewhere takes it away, ImGui forgets what was typed, so it is
    // kept here from frame to frame.
    struct Typing {
        ImGuiID field = 0;
        int frame = 0;
        std::string text;
    };
    static Typing typing;

    std::string text = value;
    ImGui::InputText(label, &text);
    const ImGuiID field = ImGui::GetID(label);
    const int frame = ImGui::GetFrameCount();
    if (ImGui::IsItemActive()) {
        typing = {field, frame, text};
        return false;
    }
    const bool was_typing = typing.field == field && typing.frame == frame - 1;
    if (!was_typing) return false;
    const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (text == value && !escaped) text = typing.text; // taken away before it could tell
    typing = {};
    if (text == value) return false;
    value = text;
    return true;
}

} // namespace atrium::gui
