// The tab of costs: what the last frame took, and which pass how much of it.

#include "app/gui/panels.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

void text(const std::string& line)
{
    ImGui::TextUnformatted(line.c_str());
}

void wrapped(const std::string& line)
{
    ImGui::PushTextWrapPos(0);
    text(line);
    ImGui::PopTextWrapPos();
}

/// 1234567 as 1 234 567.
std::string grouped(std::uint64_t number)
{
    std::string out = fmt::format("{}", number);
    for (std::size_t i = out.size(); i > 3;) out.insert(i -= 3, 1, ' ');
    return out;
}

void draw_history(const FrameFacts& facts, float scale)
{
    if (facts.history.empty()) return;
    const float most = *std::max_element(facts.history.begin(), facts.history.end());
    const int count = static_cast<int>(facts.history.size());
    ImGui::SetNextItemWidth(-1);
    ImGui::PlotLines("##history", facts.history.data(), count, std::clamp(facts.history_next, 0, count - 1),
                     fmt::format("{} frames, up to {:.1f} ms", count, most).c_str(), 0.0f, 1.2f * most,
                     {0, 56.0f * scale});
}

void draw_passes(const FrameFacts& facts)
{
    double most = 1e-6;
    for (const PassFacts& pass : facts.passes) most = std::max(most, pass.ms);
    if (!ImGui::BeginTable("passes", 3, ImGuiTableFlags_RowBg)) return;
    const float digit = ImGui::CalcTextSize("0").x;
    ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("ms", ImGuiTableColumnFlags_WidthFixed, 11 * digit);
    ImGui::TableSetupColumn("draws", ImGuiTableColumnFlags_WidthFixed, 6 * digit);
    ImGui::TableHeadersRow();
    for (const PassFacts& pass : facts.passes) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        wrapped(pass.name);
        ImGui::TableNextColumn();
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0}); // else the next cell's text stands lower
        ImGui::ProgressBar(static_cast<float>(pass.ms / most), {-1, ImGui::GetTextLineHeight()},
                           fmt::format("{:.2f}", pass.ms).c_str());
        ImGui::PopStyleVar();
        ImGui::TableNextColumn();
        if (pass.draws > 0) text(fmt::format("{}", pass.draws));
    }
    ImGui::EndTable();
}

} // namespace

void draw_cost_tab(const FrameFacts& facts, float scale)
{
    text(fmt::format("Frame  {:.2f} ms", facts.frame_ms));
    draw_history(facts, scale);
    text(fmt::format("Memory  {:.1f} MiB", static_cast<double>(facts.memory_bytes) / (1024.0 * 1024.0)));
    text(fmt::format("Triangles  {}", grouped(facts.triangles)));
    if (facts.passes.empty())
        ImGui::TextDisabled("No pass has been timed yet.");
    else
        draw_passes(facts);
}

} // namespace atrium::gui
