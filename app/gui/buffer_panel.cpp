// The tab of buffers: which there are, which are shown, and how.

#include "app/gui/panels.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

namespace atrium::gui {
namespace {

void draw_row(ViewModel& model, const std::string& name, bool shown)
{
    const auto is_it = [&](const PinnedBuffer& p) { return p.name == name; };
    bool pinned = std::any_of(model.pinned.begin(), model.pinned.end(), is_it);
    ImGui::PushID(name.c_str());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {1, 0});
    ImGui::BeginDisabled(!pinned && model.pinned.size() >= max_insets);
    if (ImGui::Checkbox("##pin", &pinned)) model.toggle_pin(name);
    ImGui::EndDisabled();
    ImGui::PopStyleVar();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Show it small at the bottom of the view");
    ImGui::SameLine();
    if (ImGui::Selectable(name.c_str(), shown)) model.settings.debug.view = name;
    ImGui::PopID();
}

void draw_list(ViewModel& model, const std::string& filter)
{
    constexpr float lines = 12;
    const float height = lines * ImGui::GetTextLineHeightWithSpacing() + 2.0f * ImGui::GetStyle().WindowPadding.y;
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    if (ImGui::BeginChild("buffers", {0, height}, true)) {
        const std::string shown = model.shown_buffer();
        bool any = false;
        for (const std::string& name : model.offered_buffers()) {
            if (!contains_words(name, filter)) continue;
            draw_row(model, name, name == shown);
            any = true;
        }
        if (!any) ImGui::TextDisabled("No buffer matches.");
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

/// The widgets of how one is shown.
void draw_look(BufferViewSettings& view, bool is_cpu)
{
    BufferViewSettings copy;
    SettingList keys;
    describe(keys, copy);
    copy = view; // only now, so that the list knows the defaults
    for (const Setting& key : keys.all()) draw_setting(key, is_cpu);
    view = copy;
}

} // namespace

void draw_buffer_tab(ViewModel& model, PanelState& state, bool is_cpu)
{
    std::string& view = model.settings.debug.view;
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##buffer filter", "Search buffers", &state.buffer_filter);
    ImGui::BeginDisabled(view.empty());
    if (ImGui::Button("back to the picture")) view.clear();
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button("frame graph")) state.graph.open = !state.graph.open;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Passes and images of the frame, drawn as a graph");
    draw_list(model, state.buffer_filter);

    const auto section = [&](const std::string& name, const char* id, BufferViewSettings& look) {
        ImGui::PushID(id);
        if (ImGui::CollapsingHeader(name.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) draw_look(look, is_cpu);
        ImGui::PopID();
    };
    if (!view.empty()) section(view + ", in place of the picture###view", "view", model.settings.buffer_view);
    for (PinnedBuffer& p : model.pinned) section(p.name, p.name.c_str(), p.view);
}

} // namespace atrium::gui
