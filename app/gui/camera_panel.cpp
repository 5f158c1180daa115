// The tab of the camera: where it stands, those with names, and paths.

#include "app/gui/controls.hpp"
#include "app/gui/panels.hpp"
#include "app/gui/text_field.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/text_value.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

namespace atrium::gui {
namespace {

void draw_fields(ViewModel& model, PanelState& state, bool is_cpu)
{
    // Described as settings are, with the camera one began with as the default.
    constexpr Range fov{1.5f, 169.0f};
    const auto within = [](const vec3& p) { return glm::clamp(p, vec3(world_range.min), vec3(world_range.max)); };
    Camera camera = model.start_camera();
    camera = {within(camera.eye), within(camera.target), std::clamp(camera.fov, fov.min, fov.max)};
    SettingList keys("camera key", "");
    keys.group("", "Camera");
    keys("eye", camera.eye, "Where it stands", world_range, "m");
    keys("target", camera.target, "What it looks at", world_range, "m");
    keys("fov", camera.fov, "Vertical field of view", fov, "degrees");
    camera = model.camera;

    bool changed = false;
    for (const Setting& key : keys.all()) changed = draw_setting(key, is_cpu) || changed;
    if (flowing_button("back to the start", true)) {
        camera = model.start_camera();
        changed = true;
    }
    if (flowing_button("frame", false)) state.frame = true;
    tooltip("Shows the selected light, or the whole scene");
    if (flowing_button("copy as options", false)) ImGui::SetClipboardText(camera_options(model.camera).c_str());
    tooltip("For the command line of atrium render");
    if (!changed) return;
    try {
        check_camera(camera, ExitCode::usage, "camera");
        model.camera = camera;
        state.message.clear();
    } catch (const Error& e) {
        state.message = fmt::format("{}: {}", e.what(), e.why());
    }
}

void draw_add_row(ViewModel& model, PanelState& state)
{
    const bool pressed = ImGui::Button("add");
    tooltip("Keeps this view of the scene under the name beside");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    const bool entered = ImGui::InputTextWithHint("##bookmark", "name of this view", &state.new_bookmark,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    if (!pressed && !entered) return;
    state.message = add_bookmark(model.bookmarks, state.new_bookmark, model.camera).value_or("");
    if (!state.message.empty()) return;
    state.new_bookmark.clear();
    state.camera = model.scene_file.cameras.size() + model.bookmarks.size() - 1;
}

void draw_selected_bookmark(ViewModel& model, PanelState& state, std::size_t index)
{
    const bool removed = ImGui::Button("remove");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    std::string name = model.bookmarks[index].first;
    if (draw_text_field("##name", name)) state.message = rename_bookmark(model.bookmarks, index, name).value_or("");
    tooltip("Its name");
    if (!removed) return;
    model.bookmarks.erase(model.bookmarks.begin() + static_cast<std::ptrdiff_t>(index));
    state.camera.reset();
}

/// The scene's, then the bookmarks.
void draw_named(ViewModel& model, PanelState& state)
{
    std::vector<std::string> lines;
    for (const auto& [name, camera] : model.scene_file.cameras) lines.push_back(name + "  of the scene");
    for (const auto& [name, camera] : model.bookmarks) lines.push_back(name);
    if (state.camera && *state.camera >= lines.size()) state.camera.reset();
    draw_add_row(model, state);
    const std::size_t of_scene = model.scene_file.cameras.size();
    if (draw_list("named", lines, state.camera, "No cameras with names yet.")) {
        const std::size_t i = *state.camera;
        model.camera = i < of_scene ? model.scene_file.cameras[i].second : model.bookmarks[i - of_scene].second;
    }
    if (state.camera && *state.camera >= of_scene) draw_selected_bookmark(model, state, *state.camera - of_scene);
}

} // namespace

void draw_camera_tab(ViewModel& model, PanelState& state, bool is_cpu)
{
    draw_fields(model, state, is_cpu);
    ImGui::Separator();
    draw_named(model, state);
    ImGui::Separator();
    draw_paths(model, state.path, state.message, state.scale);
}

std::string camera_options(const Camera& camera)
{
    const auto list = [](const vec3& v) { return fmt::format("{},{},{}", to_text(v.x), to_text(v.y), to_text(v.z)); };
    return fmt::format("--eye {} --target {} --fov {}", list(camera.eye), list(camera.target), to_text(camera.fov));
}

} // namespace atrium::gui
