#include "app/gui/panels.hpp"

#include "app/gui/controls.hpp"
#include "app/gui/split_view.hpp"
#include "app/presets.hpp"
#include "renderer/core/error.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

namespace atrium::gui {
namespace {

void draw_head(ViewModel& model, const FrameFacts& facts)
{
    if (!model.scene_name.empty()) wrapped(model.scene_name);
    const std::deque<FrameCost>& frames = facts.costs.frames();
    const std::string rate = frames.empty() ? "" : fmt::format(", {:.1f} ms", frames.back().frame_ms);
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
}

/// Pixels that the message needs at the foot of the panel: at the top, it would push away what is about to be clicked.
float message_height(const PanelState& state)
{
    if (state.message.empty()) return 0;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::GetContentRegionAvail().x - 2 * style.WindowPadding.x - style.ScrollbarSize;
    const float text = ImGui::CalcTextSize(state.message.c_str(), nullptr, false, width).y;
    const float all = text + ImGui::GetFrameHeight() + style.ItemSpacing.y + 2 * style.WindowPadding.y;
    return std::min(all, 0.5f * ImGui::GetContentRegionAvail().y);
}

void draw_message(PanelState& state)
{
    if (ImGui::BeginChild("message", {0, 0}, true)) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_PlotHistogramHovered));
        wrapped(state.message);
        ImGui::PopStyleColor();
        if (ImGui::SmallButton("Put away")) state.message.clear();
    }
    ImGui::EndChild();
}

void apply_preset(ViewModel& model, PanelState& state, const std::string& name)
{
    try {
        state.message = model.apply_texts(app::preset_settings(name)).value_or("");
    } catch (const Error& e) {
        state.message = e.text();
    }
}

void draw_settings_file(ViewModel& model, PanelState& state)
{
    if (flowing_button("save", true)) {
        try {
            model.save_settings(state.settings_file);
            state.message =
                fmt::format("{} written; --config {} draws with it", state.settings_file, state.settings_file);
        } catch (const Error& e) {
            state.message = e.text();
        }
    }
    tooltip("What differs from the defaults, as TOML for --config");
    if (flowing_button("load", false)) state.message = model.load_settings(state.settings_file).value_or("");
    tooltip("What the file says, and the defaults where it says nothing");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##file", "file of settings", &state.settings_file);
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
    draw_settings_file(model, state);

    if (flowing_button("open all", true)) state.headings = Headings::open;
    if (flowing_button("close all", false)) state.headings = Headings::close;
    draw_split_controls(model, state.scale);

    std::vector<std::string> views = model.offered_buffers();
    views.insert(views.begin(), ""); // the picture
    model.list.offer("debug.view", std::move(views));
    const Headings headings = std::exchange(state.headings, Headings::as_they_are);
    if (ImGui::BeginChild("settings")) draw_settings(model.list, state.filter, is_cpu, headings);
    ImGui::EndChild();
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
        if (!line.name.empty()) tooltip(fmt::format("{} in keys.toml", line.name).c_str());
    }
    ImGui::EndTable();
}

/// Two style variables with which the names of all tabs stand side by side uncut.
void push_narrow_tabs(float scale)
{
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2.5f * scale, ImGui::GetStyle().FramePadding.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {scale, ImGui::GetStyle().ItemInnerSpacing.y});
}

/// `foot`: pixels that stay free below them.
void draw_tabs(ViewModel& model, const FrameFacts& facts, PanelState& state, float foot)
{
    push_narrow_tabs(state.scale);
    const bool open = ImGui::BeginTabBar("tabs");
    ImGui::PopStyleVar(2);
    if (!open) return;
    const auto wanted = std::exchange(state.show, std::nullopt);
    const auto tab = [&](Tab which, const char* name, const auto& draw) {
        const ImGuiTabItemFlags flags = wanted == which ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None;
        push_narrow_tabs(state.scale);
        const bool shown = ImGui::BeginTabItem(name, nullptr, flags);
        ImGui::PopStyleVar(2);
        if (!shown) return;
        if (ImGui::BeginChild("tab", {0, -foot})) draw();
        ImGui::EndChild();
        ImGui::EndTabItem();
    };
    tab(Tab::settings, "Settings", [&] { draw_setting_tab(model, state, facts.is_cpu); });
    tab(Tab::lights, "Lights", [&] { draw_light_tab(model, state, facts.is_cpu); });
    tab(Tab::buffers, "Buffers", [&] { draw_buffer_tab(model, state, facts.is_cpu); });
    tab(Tab::camera, "Camera", [&] { draw_camera_tab(model, state, facts.is_cpu); });
    state.materials.open = false;
    tab(Tab::materials, "Materials", [&] {
        state.materials.open = true;
        draw_material_tab(model, facts.scene, state.materials, facts.is_cpu);
    });
    tab(Tab::costs, "Costs", [&] { draw_cost_tab(facts, state, model.lights.size()); });
    tab(Tab::help, "Help", [&] { draw_help_tab(state); });
    ImGui::EndTabBar();
}

} // namespace

void draw_panels(ViewModel& model, const FrameFacts& facts, PanelState& state)
{
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float margin = panel_margin * state.scale;
    ImGui::SetNextWindowPos({margin, margin});
    ImGui::SetNextWindowSize({std::min(panel_width * state.scale, display.x - 2 * margin), display.y - 2 * margin});
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("Atrium", nullptr, flags)) {
        draw_head(model, facts);
        const float foot = message_height(state);
        draw_tabs(model, facts, state, foot > 0 ? foot + ImGui::GetStyle().ItemSpacing.y : 0);
        if (foot > 0) draw_message(state);
    }
    ImGui::End();
    if (!ImGui::IsAnyItemActive() && !state.dragging) model.checkpoint();
}

} // namespace atrium::gui
