#include "app/gui/scene_statistics.hpp"

#include "app/gui/controls.hpp"

#include <string>

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

void draw_row(const char* name, const std::string& value)
{
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    wrapped(value);
}

} // namespace

void draw_scene_statistics(const SceneFacts& facts, std::size_t lights)
{
    if (!ImGui::CollapsingHeader("Scene")) return;
    if (!ImGui::BeginTable("scene", 2, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch, 0.3f);
    ImGui::TableSetupColumn("how much", ImGuiTableColumnFlags_WidthStretch, 0.7f);
    draw_row("Instances", grouped(facts.instances));
    draw_row("Meshes", grouped(facts.meshes));
    draw_row("Triangles", grouped(facts.triangles));
    draw_row("Vertices", grouped(facts.vertices));
    draw_row("Materials", grouped(facts.materials.size()));
    draw_row("Textures", fmt::format("{}, {:.1f} MiB", grouped(facts.textures),
                                     static_cast<double>(facts.texture_bytes) / (1024.0 * 1024.0)));
    draw_row("Lights", grouped(lights));
    const vec3 low = facts.bounds.min, high = facts.bounds.max;
    draw_row("Bounds", fmt::format("{:.2f} to {:.2f} m along x\n{:.2f} to {:.2f} m along y\n{:.2f} to {:.2f} m along z",
                                   low.x, high.x, low.y, high.y, low.z, high.z));
    draw_row("Loaded in", fmt::format("{:.0f} ms", facts.load_ms));
    ImGui::EndTable();
}

} // namespace atrium::gui
