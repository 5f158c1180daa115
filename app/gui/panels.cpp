#include "app/gui/panels.hpp"

#include "app/presets.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/text_value.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

namespace atrium::gui {
namespace {

void wrapped(const std::string& text)
{
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

void tooltip(const char* text)
{
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

/// A button beside the one before, or under it where the line is full.
bool flowing_button(const char* label, bool first)
{
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcTextSize(label).x + 2.0f * style.FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (!first && ImGui::GetItemRectMax().x + style.ItemSpacing.x + width < right) ImGui::SameLine();
    return ImGui::Button(label);
}

void draw_head(ViewModel& model, const FrameFacts& facts, PanelState& state)
{
    if (!model.scene_name.empty()) wrapped(model.scene_name);
    const std::string rate = facts.frame_ms > 0.0 ? fmt::format(", {:.1f} ms", facts.frame_ms) : "";
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    if (!facts.device.empty()) wrapped(facts.device);
    wrapped(fmt::format("{} x {}{}", facts.size.x, facts.size.y, rate));
    ImGui::PopStyleColor();

    ImGui::BeginDisabled(!model.can_undo());
    if (ImGui::Button("Undo")) model.undo();
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(!model.can_redo());
    if (ImGui::Button("Redo")) model.redo();
    ImGui::EndDisabled();

    if (state.message.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_PlotHistogramHovered));
    wrapped(state.message);
    ImGui::PopStyleColor();
    if (ImGui::SmallButton("Put away")) state.message.clear();
}

void apply_preset(ViewModel& model, PanelState& state, const std::string& name)
{
    try {
        state.message = model.apply_texts(app::preset_settings(name)).value_or("");
    } catch (const Error& e) {
        state.message = e.text();
    }
}

void draw_setting_tab(ViewModel& model, PanelState& state, bool is_cpu)
{
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##filter", "Search settings", &state.filter);

    if (flowing_button("defaults", true)) model.apply_defaults(is_cpu);
    tooltip("All settings back to what they are by default");
    for (const std::string& name : app::preset_names()) {
        if (flowing_button(fmt::format("{}##preset", name).c_str(), false)) apply_preset(model, state, name);
        tooltip("A preset: sets what it names and leaves the rest");
    }
    if (flowing_button("copy", false)) ImGui::SetClipboardText(model.settings_toml().c_str());
    tooltip("What differs from the defaults, as TOML for --config");

    if (flowing_button("open all", true)) state.headings = Headings::open;
    if (flowing_button("close all", false)) state.headings = Headings::close;

    std::vector<std::string> views = model.offered_buffers();
    views.insert(views.begin(), ""); // the picture
    model.list.offer("debug.view", std::move(views));
    const Headings headings = std::exchange(state.headings, Headings::as_they_are);
    if (ImGui::BeginChild("settings")) draw_settings(model.list, state.filter, is_cpu, headings);
    ImGui::EndChild();
}

void draw_camera_tab(ViewModel& model, PanelState& state, bool is_cpu)
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

void draw_help_tab(const PanelState& state)
{
    if (state.keys.empty()) ImGui::TextDisabled("There is no help.");
    if (state.keys.empty() || !ImGui::BeginTable("keys", 2, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthStretch, 0.4f);
    ImGui::TableSetupColumn("act", ImGuiTableColumnFlags_WidthStretch, 0.6f);
    for (const KeyHelp& line : state.keys) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        wrapped(line.keys);
        ImGui::TableNextColumn();
        wrapped(line.act);
    }
    ImGui::EndTable();
}

void draw_tabs(ViewModel& model, const FrameFacts& facts, PanelState& state)
{
    const ImVec2 narrow(4.0f * state.scale, ImGui::GetStyle().FramePadding.y); // else six names are cut off
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, narrow);
    const bool open = ImGui::BeginTabBar("tabs");
    ImGui::PopStyleVar();
    if (!open) return;
    const auto wanted = std::exchange(state.show, std::nullopt);
    const auto tab = [&](Tab which, const char* name, const auto& draw) {
        const ImGuiTabItemFlags flags = wanted == which ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None;
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, narrow);
        const bool shown = ImGui::BeginTabItem(name, nullptr, flags);
        ImGui::PopStyleVar();
        if (!shown) return;
        if (ImGui::BeginChild("tab")) draw();
        ImGui::EndChild();
        ImGui::EndTabItem();
    };
    tab(Tab::settings, "Settings", [&] { draw_setting_tab(model, state, facts.is_cpu); });
    tab(Tab::lights, "Lights", [&] { draw_light_tab(model, state, facts.is_cpu); });
    tab(Tab::buffers, "Buffers", [&] { draw_buffer_tab(model, state, facts.is_cpu); });
    tab(Tab::camera, "Camera", [&] { draw_camera_tab(model, state, facts.is_cpu); });
    tab(Tab::costs, "Costs", [&] { draw_cost_tab(facts, state.scale); });
    tab(Tab::help, "Help", [&] { draw_help_tab(state); });
    ImGui::EndTabBar();
}

} // namespace

void draw_panels(ViewModel& model, const FrameFacts& facts, PanelState& state)
{
    constexpr float from_edge = 8;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float margin = from_edge * state.scale;
    ImGui::SetNextWindowPos({margin, margin});
    ImGui::SetNextWindowSize({std::min(panel_width * state.scale, display.x - 2 * margin), display.y - 2 * margin});
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("Atrium", nullptr, flags)) {
        draw_head(model, facts, state);
        draw_tabs(model, facts, state);
    }
    ImGui::End();
    if (!ImGui::IsAnyItemActive() && !state.dragging) model.checkpoint();
}

std::string camera_options(const Camera& camera)
{
    const auto list = [](const vec3& v) { return fmt::format("{},{},{}", to_text(v.x), to_text(v.y), to_text(v.z)); };
    return fmt::format("--eye {} --target {} --fov {}", list(camera.eye), list(camera.target), to_text(camera.fov));
}

} // namespace atrium::gui
