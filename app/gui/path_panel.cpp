#include "app/gui/path_panel.hpp"

#include "app/gui/controls.hpp"
#include "app/gui/path_overlay.hpp"
#include "renderer/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

namespace atrium::gui {
namespace {

constexpr float latest = 1e5f; // s

/// The selected path; null where there is none.
CameraPaths::value_type* selected_path(ViewModel& model, PathPanel& panel)
{
    if (panel.path && *panel.path >= model.paths.size()) panel.path.reset();
    return panel.path ? &*std::next(model.paths.begin(), static_cast<std::ptrdiff_t>(*panel.path)) : nullptr;
}

/// A path that was selected stands at its start, and the next key would be its last.
void begin_path(PathPanel& panel, const CameraPath& path)
{
    panel.key.reset();
    panel.player = {path.front().time, false};
    panel.new_time = path.back().time + 1;
}

void draw_new_row(ViewModel& model, PathPanel& panel, std::string& message)
{
    const bool pressed = ImGui::Button("new");
    tooltip("A path that begins at this view, under the name beside");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    const bool entered =
        ImGui::InputTextWithHint("##path", "name of a new path", &panel.new_name, ImGuiInputTextFlags_EnterReturnsTrue);
    if (!pressed && !entered) return;
    message = add_path(model.paths, panel.new_name, model.camera).value_or("");
    if (!message.empty()) return;
    const auto added = model.paths.find(panel.new_name);
    panel.path = static_cast<std::size_t>(std::distance(model.paths.begin(), added));
    begin_path(panel, added->second);
    panel.new_name.clear();
}

void draw_player(const CameraPath& path, PathPlayer& player, Camera& camera)
{
    ImGui::BeginDisabled(path.size() < 2);
    if (ImGui::Button(player.playing ? "stop" : "play")) {
        if (player.playing)
            player.playing = false;
        else
            player.play(path);
    }
    tooltip("Any key that moves the camera stops it too");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    const bool scrubbed = ImGui::SliderFloat("##time", &player.time, path.front().time, path.back().time, "%.2f s",
                                             ImGuiSliderFlags_AlwaysClamp);
    ImGui::EndDisabled();
    if (!scrubbed) return;
    player.playing = false;
    camera = camera_at(path, player.time, camera);
}

void draw_add_key(CameraPath& path, PathPanel& panel, const Camera& camera, std::string& message)
{
    const bool pressed = ImGui::Button("add key");
    tooltip("This view, at the time beside");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    ImGui::InputFloat("##new time", &panel.new_time, 0.5f, 1, "%.2f s");
    panel.new_time = std::isfinite(panel.new_time) ? std::clamp(panel.new_time, -latest, latest) : 0;
    if (!pressed) return;
    const auto added = add_key(path, panel.new_time, camera);
    message = added ? "" : fmt::format("there is a key at {:.2f} s: replace it, or give another time", panel.new_time);
    if (!added) return;
    panel.key = added;
    panel.player = {panel.new_time, false};
    panel.new_time = std::min(path.back().time + 1, latest);
}

/// The keys; a click on one goes there.
void draw_keys(CameraPath& path, PathPanel& panel, Camera& camera)
{
    std::vector<std::string> lines;
    for (const CameraKey& key : path)
        lines.push_back(fmt::format("{:.2f} s   at {:.1f}, {:.1f}, {:.1f}", key.time, key.eye.x, key.eye.y, key.eye.z));
    if (panel.key && *panel.key >= path.size()) panel.key.reset();
    if (!draw_list("keys", lines, panel.key, "")) return;
    go_to(camera, path[*panel.key]);
    panel.player = {path[*panel.key].time, false};
}

void draw_path_buttons(ViewModel& model, CameraPaths::value_type& path, PathPanel& panel)
{
    auto& [name, keys] = path;
    bool remove = false;
    ImGui::BeginDisabled(!panel.key);
    if (flowing_button("replace key", true))
        keys[*panel.key] = {keys[*panel.key].time, model.camera.eye, model.camera.target};
    tooltip("The selected key becomes this view");
    if (flowing_button("remove key", false)) {
        keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(*panel.key));
        panel.key.reset();
        remove = keys.empty(); // a path has at least one
    }
    ImGui::EndDisabled();
    remove = flowing_button("remove path", false) || remove;
    if (!remove) return;
    model.paths.erase(std::string(name));
    panel.path.reset();
    panel.player = {};
}

void draw_save_row(const ViewModel& model, PathPanel& panel, std::string& message)
{
    const bool pressed = ImGui::Button("save scene");
    tooltip("Settings, lights, cameras and paths, as a scene file");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##scene file", "scene file", &panel.file);
    if (!pressed) return;
    try {
        model.save_scene(panel.file);
        message = fmt::format("{} written; atrium render and view take it as SCENE", panel.file);
    } catch (const Error& e) {
        message = e.text();
    }
}

} // namespace

void draw_paths(ViewModel& model, PathPanel& panel, std::string& message, float scale)
{
    draw_new_row(model, panel, message);
    selected_path(model, panel); // a selection that is gone
    std::vector<std::string> lines;
    for (const auto& [name, keys] : model.paths)
        lines.push_back(fmt::format("{}   {:.2f} to {:.2f} s", name, keys.front().time, keys.back().time));
    const bool clicked = draw_list("paths", lines, panel.path, "No camera paths yet.");
    if (auto* path = selected_path(model, panel)) {
        if (clicked) begin_path(panel, path->second);
        draw_player(path->second, panel.player, model.camera);
        draw_keys(path->second, panel, model.camera);
        draw_add_key(path->second, panel, model.camera, message);
        const ImVec2 display = ImGui::GetIO().DisplaySize;
        if (!panel.player.playing)
            draw_path(path->second, panel.key, Projection(model.camera, {display.x, display.y}), scale);
        draw_path_buttons(model, *path, panel);
    }
    draw_save_row(model, panel, message);
}

bool play_path(ViewModel& model, PathPanel& panel, double seconds)
{
    const auto* path = selected_path(model, panel);
    return path != nullptr && panel.player.advance(path->second, seconds, model.camera);
}

} // namespace atrium::gui
