#include "app/gui/open_dialog.hpp"

#include "app/gui/controls.hpp"

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <utility>

namespace atrium::gui {
namespace {

constexpr const char* title = "Open a scene";

/// Begins the dialog in the middle of the display.
bool begin_dialog(float scale)
{
    constexpr float width = 560, height = 420, from_edge = 8;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float margin = 2 * from_edge * scale;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::min(width * scale, display.x - margin), std::min(height * scale, display.y - margin)});
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;
    return ImGui::BeginPopupModal(title, nullptr, flags);
}

} // namespace

void OpenDialog::go_on_with(const std::string& text)
{
    typed_ = text;
    listing_ = list_scenes(typed_);
    takes_keys_ = cursor_to_end_ = true;
}

bool OpenDialog::draw_field()
{
    // The field keeps a text of its own while it has the keyboard: only from within can it be changed then.
    const auto edit = [](ImGuiInputTextCallbackData* field) {
        OpenDialog& self = *static_cast<OpenDialog*>(field->UserData);
        if (field->EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
            const std::string completed = list_scenes(field->Buf).completed;
            field->DeleteChars(0, field->BufTextLen);
            field->InsertChars(0, completed.c_str());
        } else if (std::exchange(self.cursor_to_end_, false)) {
            field->CursorPos = field->SelectionStart = field->SelectionEnd = field->BufTextLen;
        }
        return 0;
    };
    if (std::exchange(takes_keys_, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const std::string before = typed_;
    const bool entered =
        ImGui::InputTextWithHint("##file", "path of a bake (.atrium), a scene file (.toml) or an OBJ", &typed_,
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackCompletion |
                                     ImGuiInputTextFlags_CallbackAlways,
                                 edit, this);
    if (typed_ != before) listing_ = list_scenes(typed_);
    return entered;
}

std::optional<std::filesystem::path> OpenDialog::draw_lists(std::span<const std::filesystem::path> recent)
{
    std::optional<std::filesystem::path> chosen;
    int id = 0;
    const auto line = [&](const std::string& text) {
        ImGui::PushID(id++);
        const bool clicked = list_line(text, false);
        ImGui::PopID();
        return clicked;
    };
    if (typed_.empty()) {
        ImGui::TextDisabled("Recent");
        for (const std::filesystem::path& file : recent) {
            if (line(fmt::format("{}  in {}", file.filename().string(), file.parent_path().string()))) chosen = file;
        }
        ImGui::Spacing();
    }
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    wrapped(listing_.folder.string());
    if (listing_.lines.empty()) wrapped("No scenes and no folders that begin so.");
    ImGui::PopStyleColor();
    std::optional<std::string> folder;
    for (const std::string& name : listing_.lines) {
        if (!line(name)) continue;
        if (name.ends_with('/'))
            folder = with_line(typed_, name);
        else
            chosen = listing_.folder / name;
    }
    if (folder) go_on_with(*folder);
    return chosen;
}

std::optional<std::filesystem::path> OpenDialog::draw(std::span<const std::filesystem::path> recent, float scale)
{
    if (std::exchange(wanted_, false)) {
        ImGui::OpenPopup(title);
        go_on_with(typed_);
    }
    open_ = begin_dialog(scale);
    if (!open_) return std::nullopt;

    std::optional<std::filesystem::path> chosen;
    const bool entered = draw_field();
    const float buttons = ImGui::GetFrameHeightWithSpacing();
    if (ImGui::BeginChild("lists", {0, -buttons}, true)) chosen = draw_lists(recent);
    ImGui::EndChild();
    ImGui::BeginDisabled(typed_.empty());
    const bool pressed = ImGui::Button("Open");
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool closes = ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));

    if ((entered || pressed) && !typed_.empty()) {
        std::error_code unknown; // is told when it is opened
        if (std::filesystem::is_directory(typed_path(typed_), unknown))
            go_on_with(typed_.ends_with('/') ? typed_ : typed_ + '/');
        else
            chosen = typed_path(typed_);
    }
    if (chosen) typed_.clear();
    if (chosen || closes) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

} // namespace atrium::gui
