// The tab of lights: which there are, and the keys of the selected one.

#include "app/gui/controls.hpp"
#include "app/gui/panels.hpp"

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
        tooltip("Stands where the camera looks");
    }
    ImGui::EndDisabled();
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
    std::vector<std::string> lines;
    for (const Light& light : model.lights) lines.push_back(fmt::format("{}  {}", light.name, to_string(light.type)));
    draw_list("list", lines, model.selected, "None yet.");
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
