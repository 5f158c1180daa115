// The tab of costs: what the last frame took, and which pass how much of it.

#include "app/gui/controls.hpp"
#include "app/gui/panels.hpp"
#include "app/gui/scene_statistics.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

void text(const std::string& line)
{
    ImGui::TextUnformatted(line.c_str());
}

/// A hue of its own for each pass, neighbours far apart.
ImU32 color_of(std::size_t pass)
{
    constexpr float golden_ratio = 0.618034f;
    const float hue = static_cast<float>(pass) * golden_ratio;
    return ImColor::HSV(hue - std::floor(hue), 0.55f, 0.8f);
}

/// What the passes of one frame took, above each other.
void draw_stack(const FrameCost& frame, ImVec2 foot, float width, float per_ms)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    float top = foot.y;
    for (const PassCost& pass : frame.passes) {
        const float bottom = top;
        top -= per_ms * static_cast<float>(pass.ms);
        draw.AddRectFilled({foot.x, top}, {foot.x + width, bottom}, color_of(pass.index));
    }
}

void draw_frame_tip(const FrameCost& frame)
{
    ImGui::BeginTooltip();
    text(fmt::format("{:.2f} ms, {:.2f} ms of it on the processor", frame.frame_ms, frame.cpu_ms));
    std::vector<PassCost> passes = frame.passes;
    std::sort(passes.begin(), passes.end(), [](const PassCost& a, const PassCost& b) { return a.ms > b.ms; });
    passes.resize(std::min<std::size_t>(passes.size(), 6));
    for (const PassCost& pass : passes) text(fmt::format("{:8.2f} ms  {}", pass.ms, pass.name));
    ImGui::EndTooltip();
}

void draw_history(const FrameFacts& facts, float scale)
{
    const std::deque<FrameCost>& frames = facts.costs.frames();
    if (frames.empty()) return;
    std::vector<double> sums;
    for (const FrameCost& frame : frames) {
        sums.push_back(0);
        for (const PassCost& pass : frame.passes) sums.back() += pass.ms;
    }
    std::sort(sums.begin(), sums.end());
    const double median = sums[sums.size() / 2];
    const double top = std::max(std::min(sums.back(), 4 * median), 1e-6); // a first frame takes seconds: it is cut
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, 72.0f * scale};
    ImGui::InvisibleButton("##history", {std::max(size.x, 1.0f), size.y});
    const bool pointed = ImGui::IsItemHovered();
    const ImVec2 to{from.x + size.x, from.y + size.y};
    ImGui::GetWindowDrawList()->AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg));
    ImGui::GetWindowDrawList()->PushClipRect(from, to, true);

    const float width = size.x / static_cast<float>(CostHistory::longest); // the newest stands at the right
    float x = to.x - width * static_cast<float>(frames.size());
    for (const FrameCost& frame : frames) {
        draw_stack(frame, {x, to.y}, width, 0.95f * size.y / static_cast<float>(top));
        const float mouse = ImGui::GetIO().MousePos.x;
        if (pointed && mouse >= x && mouse < x + width) draw_frame_tip(frame);
        x += width;
    }
    ImGui::GetWindowDrawList()->PopClipRect();
    ImGui::TextDisabled("%s", fmt::format("{} frames, half of them up to {:.1f} ms", frames.size(), median).c_str());
}

void draw_passes(const FrameCost& last)
{
    double most = 1e-6;
    for (const PassCost& pass : last.passes) most = std::max(most, pass.ms);
    if (!ImGui::BeginTable("passes", 3, ImGuiTableFlags_RowBg)) return;
    const float digit = ImGui::CalcTextSize("0").x;
    ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("ms", ImGuiTableColumnFlags_WidthFixed, 11 * digit);
    ImGui::TableSetupColumn("draws", ImGuiTableColumnFlags_WidthFixed, 6 * digit);
    ImGui::TableHeadersRow();
    for (const PassCost& pass : last.passes) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        wrapped(pass.name);
        ImGui::TableNextColumn();
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0}); // else the next cell's text stands lower
        ImGui::PushStyleColor(ImGuiCol_PlotHistogram, color_of(pass.index));
        ImGui::ProgressBar(static_cast<float>(pass.ms / most), {-1, ImGui::GetTextLineHeight()},
                           fmt::format("{:.2f}", pass.ms).c_str());
        ImGui::PopStyleColor();
        ImGui::PopStyleVar();
        ImGui::TableNextColumn();
        if (pass.draws > 0) text(fmt::format("{}", pass.draws));
    }
    ImGui::EndTable();
}

void draw_memory(const FrameFacts& facts)
{
    const auto mib = [](std::uint64_t bytes) { return static_cast<double>(bytes) / (1024.0 * 1024.0); };
    for (const HeapFacts& heap : facts.heaps) {
        wrapped(fmt::format("Memory {}  {:.1f} of {:.0f} MiB", heap.on_device ? "on the device" : "of the host",
                            mib(heap.used), mib(heap.budget)));
    }
}

void draw_frames(const FrameFacts& facts, PanelState& state)
{
    if (facts.costs.frames().empty()) {
        ImGui::TextDisabled("No frame has been timed yet.");
        return;
    }
    const FrameCost& last = facts.costs.frames().back();
    std::uint32_t draws = 0;
    for (const PassCost& pass : last.passes) draws += pass.draws;
    wrapped(fmt::format("Frame  {:.2f} ms, {:.2f} ms of it on the processor", last.frame_ms, last.cpu_ms));
    wrapped(fmt::format("Interface  {:.2f} ms, into the window  {:.2f} ms", facts.interface_ms, facts.picture_ms));
    wrapped(fmt::format("Draws  {}, triangles  {}", grouped(draws), grouped(facts.triangles)));
    draw_history(facts, state.scale);
    if (ImGui::Button("save as JSON")) state.save_costs = CostFile::json;
    ImGui::SameLine();
    if (ImGui::Button("save as trace")) state.save_costs = CostFile::trace;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("For ui.perfetto.dev or chrome://tracing");
    draw_passes(last);
}

} // namespace

void draw_cost_tab(const FrameFacts& facts, PanelState& state, std::size_t lights)
{
    draw_memory(facts);
    draw_frames(facts, state);
    draw_scene_statistics(facts.scene, lights);
}

} // namespace atrium::gui
