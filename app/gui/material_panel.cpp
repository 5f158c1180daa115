#include "app/gui/material_panel.hpp"

#include "app/gui/controls.hpp"
#include "app/gui/setting_widgets.hpp"
#include "app/gui/ui_image.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

namespace atrium::gui {
namespace {

std::vector<std::size_t> matching(const ViewModel& model, std::string_view filter)
{
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < model.scene_materials.size(); ++i)
        if (contains_words(model.scene_materials[i].name, filter)) out.push_back(i);
    return out;
}

/// Linear to what the interface is written in, about.
ImU32 encoded(const vec3& linear)
{
    const vec3 c = glm::pow(glm::clamp(linear, 0.0f, 1.0f), vec3(1 / 2.2f));
    return ImGui::GetColorU32({c.x, c.y, c.z, 1});
}

/// A square of the base colour.
void draw_thumbnail(const Material& material, const MaterialFacts& facts, ImVec2 from, float side)
{
    const ImVec2 to{from.x + side, from.y + side};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (facts.image) {
        draw.AddImage(ui_image(*facts.image), from, to, {0, 0}, {1, 1}, encoded(material.base_color));
    } else {
        draw.AddRectFilled(from, to, encoded(material.base_color));
    }
}

std::string counts(const MaterialFacts& facts)
{
    return fmt::format("{} mesh{}, {} triangles, {} texture{}", grouped(facts.meshes), facts.meshes == 1 ? "" : "es",
                       grouped(facts.triangles), facts.textures.size(), facts.textures.size() == 1 ? "" : "s");
}

/// Thumbnail and name; the class under it. What is too long is cut, and whole in the tooltip.
void draw_line(ViewModel& model, const MaterialFacts& facts, std::size_t index, float height)
{
    const Material material = model.material(index);
    const bool changed = !difference(model.scene_materials[index], material).values.empty();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##line", model.selected_material == index, 0, {ImGui::GetContentRegionAvail().x, height}))
        model.selected_material = index;
    tooltip(fmt::format("{}\n{}{}", material.name, counts(facts), changed ? "\nchanged" : "").c_str());
    draw_thumbnail(material, facts, from, height);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float x = from.x + height + ImGui::GetStyle().ItemSpacing.x;
    const std::string name = material.name + (changed ? " *" : "");
    const std::string size = fmt::format("{}, {} triangles", to_string(material.cls), grouped(facts.triangles));
    draw.AddText({x, from.y}, ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
    draw.AddText({x, from.y + 0.5f * height}, ImGui::GetColorU32(ImGuiCol_TextDisabled), size.c_str());
}

void draw_materials(ViewModel& model, const SceneFacts& facts, MaterialTab& tab)
{
    const std::vector<std::size_t> shown = matching(model, tab.filter);
    const float height = 2 * ImGui::GetTextLineHeight() + 4, pitch = height + ImGui::GetStyle().ItemSpacing.y;
    const float lines = std::clamp(static_cast<float>(shown.size()), 1.0f, 6.0f);
    // What is selected needs room below.
    const float most = (model.selected_material ? 0.4f : 1.0f) * ImGui::GetContentRegionAvail().y;
    const float wanted = lines * pitch + 2 * ImGui::GetStyle().WindowPadding.y;
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    if (ImGui::BeginChild("materials", {0, std::max(std::min(wanted, most), pitch)}, true)) {
        if (shown.empty()) ImGui::TextDisabled("None of that name.");
        const auto selected =
            model.selected_material ? std::find(shown.begin(), shown.end(), *model.selected_material) : shown.end();
        if (tab.scroll && selected != shown.end())
            ImGui::SetScrollY((static_cast<float>(selected - shown.begin()) + 0.5f) * pitch -
                              0.5f * ImGui::GetWindowHeight());
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(shown.size()), pitch);
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                const std::size_t index = shown[static_cast<std::size_t>(i)];
                ImGui::PushID(static_cast<int>(index));
                draw_line(model, facts.materials[index], index, height);
                ImGui::PopID();
            }
        }
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    tab.scroll = false;
}

void draw_keys(ViewModel& model, std::size_t index, bool is_cpu)
{
    Material material;
    SettingList keys("material key", "");
    describe(keys, material);
    for (Setting key : keys.all()) {
        material = model.scene_materials[index];
        key.default_text = key.cpu_default = key.get(); // the arrow leads back to what the scene says
        material = model.material(index);
        if (draw_setting(key, is_cpu)) model.set_material(index, material);
    }
}

void draw_textures(const MaterialFacts& facts)
{
    for (const TextureFacts& texture : facts.textures) {
        wrapped(fmt::format("{}: {}", texture.use, texture.file));
        ImGui::TextDisabled("%s", fmt::format("{} x {}, {}, {:.0f} KiB", texture.size.x, texture.size.y, texture.format,
                                              static_cast<double>(texture.bytes) / 1024)
                                      .c_str());
    }
}

} // namespace

void draw_material_tab(ViewModel& model, const SceneFacts& facts, MaterialTab& tab, bool is_cpu)
{
    if (model.selected_material && *model.selected_material >= model.scene_materials.size())
        model.selected_material.reset();
    if (model.scene_materials.size() != facts.materials.size()) return; // nothing is loaded
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##filter", "Search materials; a click in the scene selects one", &tab.filter);
    draw_materials(model, facts, tab);
    if (!model.selected_material) return;
    const std::size_t index = *model.selected_material;
    const Material& from_scene = model.scene_materials[index];
    wrapped(fmt::format("{}: {}", from_scene.name, counts(facts.materials[index])));
    ImGui::BeginDisabled(difference(from_scene, model.material(index)).values.empty());
    if (flowing_button("reset", true)) model.set_material(index, from_scene);
    ImGui::EndDisabled();
    tooltip("All its keys back to what the scene says");
    ImGui::BeginDisabled(model.materials.empty());
    if (flowing_button("reset all materials", false)) model.materials.clear();
    ImGui::EndDisabled();
    ImGui::PushID(static_cast<int>(index));
    if (ImGui::BeginChild("keys")) {
        draw_keys(model, index, is_cpu);
        ImGui::Separator();
        draw_textures(facts.materials[index]);
    }
    ImGui::EndChild();
    ImGui::PopID();
}

} // namespace atrium::gui
