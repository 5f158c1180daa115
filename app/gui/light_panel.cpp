// The tab of lights: which there are, and the keys of the selected one.

#include "app/gui/panels.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

void draw_add_buttons(ViewModel& model)
{
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Add");
    ImGui::BeginDisabled(model.lights.size() >= max_lights);
    for (const LightType type : {LightType::sun, LightType::spot, LightType::point, LightType::rect}) {
        ImGui::SameLine();
        if (ImGui::Button(to_string(type))) model.add_light(type, model.camera.target);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Stands where the camera looks");
    }
    ImGui::EndDisabled();
}

void draw_list(ViewModel& model)
{
    // As high as its lines, up to eight: the selected light's keys stand below it.
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float lines = std::clamp(static_cast<float>(model.lights.size()), 1.0f, 8.0f);
    const float height = line * lines + 2.0f * ImGui::GetStyle().WindowPadding.y;
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    if (ImGui::BeginChild("list", {0, height}, true)) {
        if (model.lights.empty()) ImGui::TextDisabled("None yet.");
        for (std::size_t i = 0; i < model.lights.size(); ++i) {
            const Light& light = model.lights[i];
            ImGui::PushID(static_cast<int>(i));
            const std::string label = fmt::format("{}  {}", light.name, to_string(light.type));
            const float width = ImGui::GetContentRegionAvail().x; // a longer name is cut, and whole in its tooltip
            if (ImGui::Selectable(fmt::format("{}###light", label).c_str(), model.selected == i, 0, {width, 0})) {
                model.selected = i;
            }
            if (ImGui::IsItemHovered() && ImGui::CalcTextSize(label.c_str()).x > width) {
                ImGui::SetTooltip("%s", label.c_str());
            }
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

void draw_selected(ViewModel& model, PanelState& state, bool is_cpu)
{
    const std::size_t index = *model.selected;
    Light light = default_light(model.lights[index].type);
    SettingList keys("light key", "");
    describe(keys, light);
    light = model.lights[index]; // only now, so that the list knows the defaults
    bool changed = false;
    ImGui::PushID(static_cast<int>(index));
    for (const Setting& key : keys.all()) changed = draw_setting(key, is_cpu) || changed;
    ImGui::PopID();
    if (changed) state.message = model.set_light(index, light).value_or("");
}

} // namespace

void draw_light_tab(ViewModel& model, PanelState& state, bool is_cpu)
{
    if (model.selected && *model.selected >= model.lights.size()) model.selected.reset();
    draw_add_buttons(model);
    draw_list(model);
    ImGui::BeginDisabled(!model.selected);
    ImGui::BeginDisabled(model.lights.size() >= max_lights);
    if (ImGui::Button("Duplicate")) model.duplicate_selected();
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button("Remove")) model.remove_selected();
    ImGui::EndDisabled();
    if (!model.selected) return;
    ImGui::Separator();
    draw_selected(model, state, is_cpu);
}

} // namespace atrium::gui
