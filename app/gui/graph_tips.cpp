#include "app/gui/graph_tips.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

constexpr std::size_t most_lines = 16;

std::string memory_text(std::uint64_t bytes)
{
    const auto kib = static_cast<double>(bytes) / 1024;
    return kib < 1024 ? fmt::format("{:.1f} KiB", kib) : fmt::format("{:.1f} MiB", kib / 1024);
}

std::string layers_text(const GraphResourceFacts& image)
{
    return image.layers == 1 ? "" : fmt::format(" x {}", image.layers);
}

/// The first of them; of the rest, how many.
void draw_lines(std::vector<std::string> lines)
{
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    for (std::size_t i = 0; i < std::min(lines.size(), most_lines); ++i) ImGui::TextUnformatted(lines[i].c_str());
    if (lines.size() > most_lines) ImGui::TextDisabled("and %d more", static_cast<int>(lines.size() - most_lines));
}

std::string use_text(const GraphUseFacts& use, const std::string& other)
{
    return fmt::format("{} {}: {}", use.writes ? "writes" : "reads", other, use.access);
}

void draw_pass_tip(const GraphFacts& graph, const GraphBox& box)
{
    std::vector<std::string> lines;
    for (const GraphUseFacts& use : graph.uses) {
        if (use.pass < box.first_pass || use.pass >= box.first_pass + box.passes) continue;
        lines.push_back(use_text(use, graph.resources[use.resource].name));
    }
    const std::size_t first = box.first_pass + 1, last = box.first_pass + box.passes, all = graph.passes.size();
    ImGui::TextDisabled("%s", box.passes == 1 ? fmt::format("pass {} of {}", first, all).c_str()
                                              : fmt::format("passes {} to {} of {}", first, last, all).c_str());
    draw_lines(std::move(lines));
}

void draw_image_tip(const GraphFacts& graph, std::size_t image)
{
    const GraphResourceFacts& facts = graph.resources[image];
    std::vector<std::string> lines;
    std::size_t first = graph.passes.size(), last = 0;
    for (const GraphUseFacts& use : graph.uses) {
        if (use.resource != image) continue;
        first = std::min(first, use.pass);
        last = std::max(last, use.pass);
        const std::string& pass = graph.passes[use.pass].name;
        lines.push_back(fmt::format("{} {}: {}", pass, use.writes ? "writes" : "reads", use.access));
    }
    if (facts.outlives_frame)
        ImGui::TextDisabled("outlives the frame");
    else
        ImGui::TextDisabled(
            "%s", fmt::format("lives from {} to {}", graph.passes[first].name, graph.passes[last].name).c_str());
    std::string shares;
    for (const std::size_t other : facts.shares) shares += (shares.empty() ? "" : ", ") + graph.resources[other].name;
    if (!shares.empty()) ImGui::TextDisabled("%s", ("shares memory with " + shares).c_str());
    draw_lines(std::move(lines));
    ImGui::TextDisabled("click: show it small; right button: large");
}

} // namespace

std::string title_of(const GraphFacts& graph, const GraphBox& box)
{
    if (box.image) return graph.resources[*box.image].name;
    const std::string& first = graph.passes[box.first_pass].name;
    if (box.passes == 1) return first;
    const std::string& last = graph.passes[box.first_pass + box.passes - 1].name;
    return fmt::format("{} to {}", first, last.substr(last.rfind('.') + 1));
}

double gpu_ms(const GraphFacts& graph, const GraphBox& box)
{
    double sum = 0;
    for (std::size_t p = 0; p < box.passes; ++p) sum += graph.passes[box.first_pass + p].gpu_ms;
    return sum;
}

std::string subtitle_of(const GraphFacts& graph, const GraphBox& box)
{
    if (!box.image) return fmt::format("{:.2f} ms", gpu_ms(graph, box));
    const GraphResourceFacts& image = graph.resources[*box.image];
    return fmt::format("{}  {} x {}{}  {}", image.format, image.size.x, image.size.y, layers_text(image),
                       memory_text(image.bytes));
}

std::string summary_of(const GraphFacts& graph)
{
    const auto images = std::count_if(graph.resources.begin(), graph.resources.end(),
                                      [](const GraphResourceFacts& r) { return r.can_be_shown; });
    double ms = 0;
    for (const GraphPassFacts& pass : graph.passes) ms += pass.gpu_ms;
    return fmt::format("{} passes, {:.1f} ms; {} images", graph.passes.size(), ms, images);
}

void draw_graph_tip(const GraphFacts& graph, const GraphBox& box)
{
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(title_of(graph, box).c_str());
    ImGui::TextUnformatted(subtitle_of(graph, box).c_str());
    if (box.image)
        draw_image_tip(graph, *box.image);
    else
        draw_pass_tip(graph, box);
    ImGui::EndTooltip();
}

} // namespace atrium::gui
