// Over the view: pinned buffers, legends, and the values under the mouse.

#include "app/gui/inset_layout.hpp"
#include "app/gui/panels.hpp"
#include "shaders/shared/buffer_view.h"
#include "shaders/shared/viridis.h"

#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

constexpr float legend_width = 200, margin = 8; ///< x scale
constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize;

std::string short_text(float value)
{
    return fmt::format("{:.3g}", value);
}

float width_of(const std::string& text)
{
    return ImGui::CalcTextSize(text.c_str()).x;
}

void text_at(float x, const std::string& text)
{
    ImGui::SetCursorPosX(x);
    ImGui::TextUnformatted(text.c_str());
}

/// Left, middle and right of the same line.
void draw_thirds(const std::array<std::string, 3>& texts, float width)
{
    const float left = ImGui::GetCursorPosX();
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        text_at(left + 0.5f * static_cast<float>(i) * (width - width_of(texts[i])), texts[i]);
    }
}

ImU32 color_at(float t, bool viridis)
{
    // Grey is encoded as the picture is. Source of the curve: IEC 61966-2-1, without its short straight part.
    const vec3 c = viridis ? shared::viridis(t) : vec3(1.055f * std::pow(t, 1 / 2.4f) - 0.055f);
    return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1});
}

/// A bar from the darkest to the brightest colour, and the values that have them beside it.
void draw_bar(const BufferFacts& facts, bool viridis, float width)
{
    constexpr int steps = 32;
    const std::string low = short_text(facts.range.x), high = short_text(facts.range.y);
    const float gap = ImGui::GetStyle().ItemSpacing.x, height = ImGui::GetTextLineHeight();
    ImGui::TextUnformatted(low.c_str());
    ImGui::SameLine();
    const float bar = width - width_of(low) - width_of(high) - 2 * gap;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int i = 0; i < steps; ++i) {
        const float a = static_cast<float>(i) / steps, b = static_cast<float>(i + 1) / steps;
        const ImU32 left = color_at(a, viridis), right = color_at(b, viridis);
        list.AddRectFilledMultiColor({from.x + a * bar, from.y + 0.2f * height},
                                     {from.x + b * bar, from.y + 0.9f * height}, left, right, right, left);
    }
    ImGui::Dummy({bar, height});
    ImGui::SameLine();
    ImGui::TextUnformatted(high.c_str());
}

/// What the colours mean, and minimum, mean and maximum.
void draw_legend(const BufferFacts& facts, float width)
{
    if (facts.mode == shared::view_index)
        ImGui::TextDisabled("a colour for each index");
    else
        draw_bar(facts, facts.mode == shared::view_viridis, width);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    draw_thirds({"min", "mean", "max"}, width);
    ImGui::PopStyleColor();
    const auto number = [&](float value) { return facts.count > 0 ? short_text(value) : std::string("none"); };
    draw_thirds({number(facts.low), number(facts.mean), number(facts.high)}, width);
}

/// Without its end, if need be, but never a part of a character.
std::string shortened(std::string text, float width)
{
    if (width_of(text) <= width) return text;
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; }; // in UTF-8
    while (!text.empty() && width_of(text + "...") > width) {
        while (continues(text.back()) && text.size() > 1) text.pop_back();
        text.pop_back();
    }
    return text + "...";
}

void draw_name(const std::string& name, float width)
{
    ImGui::TextUnformatted(shortened(name, width).c_str());
}

void draw_values(const FrameFacts& facts, std::size_t buffer, vec2 at)
{
    if (facts.buffers[buffer].facts.absent) return;
    const std::vector<float> values = facts.buffer_value ? facts.buffer_value(buffer, at) : std::vector<float>{};
    if (values.empty()) return;
    ImGui::BeginTooltip();
    ImGui::TextDisabled("%s", facts.buffers[buffer].name.c_str());
    ImGui::TextUnformatted(fmt::format("{:.6g}", fmt::join(values, "  ")).c_str());
    ImGui::EndTooltip();
}

const BufferFacts& facts_of(const FrameFacts& facts, std::size_t buffer, const std::string& name)
{
    static const BufferFacts none;
    return buffer < facts.buffers.size() && facts.buffers[buffer].name == name ? facts.buffers[buffer].facts : none;
}

/// In place of an image that the frame does not have; `width`: that there is for it.
void draw_absence(ImDrawList& list, ImVec2 centre, float width)
{
    constexpr const char* text = "Not in this frame: its technique is off, or no such image exists.";
    const float wrap = 0.9f * width;
    const ImVec2 size = ImGui::CalcTextSize(text, nullptr, false, wrap);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {centre.x - 0.5f * size.x, centre.y - 0.5f * size.y},
                 ImGui::GetColorU32(ImGuiCol_PlotHistogramHovered), text, nullptr, wrap);
}

enum class Wish { none, enlarge, remove };

/// The pinned buffer `index`, its lower left corner there.
Wish draw_inset(const ViewModel& model, const FrameFacts& facts, std::size_t index, vec2 corner,
                const InsetLayout& layout)
{
    const ImVec2 size(static_cast<float>(layout.image.x), static_cast<float>(layout.image.y));
    const PinnedBuffer& p = model.pinned[index];
    const std::size_t buffer = index + (model.settings.debug.view.empty() ? 0 : 1);
    const BufferFacts& shown = facts_of(facts, buffer, p.name);
    Wish wish = Wish::none;
    ImGui::SetNextWindowPos({corner.x, corner.y}, ImGuiCond_Always, {0, 1});
    if (ImGui::Begin(fmt::format("inset {}", p.name).c_str(), nullptr, flags)) {
        const float left = ImGui::GetCursorPosX(), button = ImGui::GetTextLineHeight();
        draw_name(p.name, size.x - button - ImGui::GetStyle().ItemSpacing.x);
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + size.x - button);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
        if (ImGui::Button("x", {button, button})) wish = Wish::remove;
        ImGui::PopStyleVar();

        const auto count = static_cast<float>(model.pinned.size()), at = static_cast<float>(index);
        const ImVec2 from = ImGui::GetCursorScreenPos();
        ImGui::Image(facts.insets, size, {at / count, 0}, {(at + 1) / count, 1});
        if (shown.absent)
            draw_absence(*ImGui::GetWindowDrawList(), {from.x + 0.5f * size.x, from.y + 0.5f * size.y}, size.x);
        if (ImGui::IsItemClicked()) wish = Wish::enlarge;
        if (ImGui::IsItemHovered() && buffer < facts.buffers.size()) {
            const ImVec2 mouse = ImGui::GetMousePos();
            draw_values(facts, buffer, {(mouse.x - from.x) / size.x, (mouse.y - from.y) / size.y});
        }
        if (layout.with_legend) draw_legend(shown, size.x);
    }
    ImGui::End();
    return wish;
}

void draw_insets(ViewModel& model, const FrameFacts& facts, float scale)
{
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const uvec2 window(static_cast<std::uint32_t>(display.x), static_cast<std::uint32_t>(display.y));
    const InsetLayout layout = lay_out_insets(window, scale, model.pinned.size());
    std::optional<PinnedBuffer> enlarged, removed;
    for (std::size_t i = 0; i < model.pinned.size(); ++i) {
        const vec2 corner = vec2(layout.origin) + vec2(layout.step) * vec2(i % layout.columns, 0) -
                            vec2(layout.step) * vec2(0, i / layout.columns);
        const Wish wish = draw_inset(model, facts, i, corner, layout);
        if (wish == Wish::enlarge) enlarged = model.pinned[i];
        if (wish == Wish::remove) removed = model.pinned[i];
    }
    if (removed) model.toggle_pin(removed->name);
    if (!enlarged) return;
    model.settings.debug.view = enlarged->name;
    model.settings.buffer_view = enlarged->view;
}

/// Legend of the buffer in place of the picture.
void draw_full_view(ViewModel& model, const std::string& name, const FrameFacts& facts, float scale)
{
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const BufferFacts& shown = facts_of(facts, 0, name);
    const float left = panel_end * scale;
    if (shown.absent)
        draw_absence(*ImGui::GetBackgroundDrawList(), {0.5f * (left + display.x), 0.5f * display.y}, display.x - left);
    ImGui::SetNextWindowPos({display.x - margin * scale, margin * scale}, ImGuiCond_Always, {1, 0});
    if (ImGui::Begin("full view", nullptr, flags)) {
        const float width = legend_width * scale;
        draw_name(name, width);
        draw_legend(shown, width);
        if (ImGui::Button("back to the picture", {width, 0})) model.settings.debug.view.clear();
    }
    ImGui::End();
    const ImVec2 mouse = ImGui::GetMousePos();
    const bool at_other_side = model.split && mouse.x < model.split->divider * display.x; // which shows something else
    const bool over_view =
        !ImGui::GetIO().WantCaptureMouse && ImGui::IsMousePosValid() && !ImGui::IsAnyMouseDown() && !at_other_side;
    if (over_view && !facts.buffers.empty()) draw_values(facts, 0, {mouse.x / display.x, mouse.y / display.y});
}

} // namespace

void draw_buffers(ViewModel& model, const FrameFacts& facts, float scale)
{
    if (const std::string name = model.shown_buffer(); !name.empty()) draw_full_view(model, name, facts, scale);
    model.drop_lost_buffers();
    draw_insets(model, facts, scale);
}

} // namespace atrium::gui
