#include "app/gui/graph_window.hpp"

#include "app/gui/graph_images.hpp"
#include "app/gui/graph_layout.hpp"
#include "app/gui/graph_tips.hpp"
#include "app/gui/panels.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

// Pixels at scale and zoom 1.
constexpr float margin = 8, padding = 7, narrowest = 96;
constexpr vec2 gaps{48, 14}, thumbnail{64, 36};
constexpr std::size_t none = ~std::size_t{0}; ///< no box
constexpr float smallest_zoom = 0.08f, largest_zoom = 2;

ImVec2 im(const vec2& v)
{
    return {v.x, v.y};
}

vec2 text_size(const std::string& text)
{
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    return {size.x, size.y};
}

vec2 size_of(const GraphFacts& graph, const GraphBox& box, float scale)
{
    const vec2 title = text_size(title_of(graph, box)), below = text_size(subtitle_of(graph, box));
    vec2 size(std::max({title.x, below.x, narrowest * scale}), title.y + below.y);
    if (box.image) {
        size.x += (thumbnail.x + padding) * scale;
        size.y = std::max(size.y, thumbnail.y * scale);
    }
    return size + 2 * padding * scale;
}

/// All that boxes and lines depend on: not what passes took.
std::string structure_of(const GraphFacts& graph, float scale)
{
    std::string out = fmt::format("{}", scale);
    for (const GraphPassFacts& pass : graph.passes) out += "\n" + pass.name;
    for (const GraphResourceFacts& r : graph.resources)
        out += fmt::format("\n{} {} {}x{}", r.name, r.format, r.size.x, r.size.y);
    for (const GraphUseFacts& use : graph.uses) out += fmt::format(" {},{},{:d}", use.pass, use.resource, use.writes);
    return out;
}

/// Of all boxes different.
std::string key_of(const GraphFacts& graph, const GraphBox& box)
{
    return (box.image ? "image " : "pass ") + title_of(graph, box);
}

void lay_out(const GraphFacts& graph, GraphWindow& window, float scale)
{
    std::string structure = structure_of(graph, scale);
    if (structure == window.structure) return;
    window.structure = std::move(structure);
    window.drawing = make_graph_boxes(graph);
    window.sizes.clear();
    for (const GraphBox& box : window.drawing.boxes) window.sizes.push_back(size_of(graph, box, scale));
    std::vector<GraphEdge> edges;
    for (const GraphLine& line : window.drawing.lines) edges.push_back({line.from, line.to});
    window.corners = lay_out_graph(window.sizes, edges, gaps * scale);
    for (std::size_t i = 0; i < window.corners.size(); ++i) {
        if (key_of(graph, window.drawing.boxes[i]) != window.pointed) continue;
        window.origin += window.zoom * (window.pointed_at - window.corners[i]);
    }
}

/// Of all boxes together.
vec2 extent(const GraphWindow& window)
{
    vec2 out(1);
    for (std::size_t i = 0; i < window.corners.size(); ++i) out = glm::max(out, window.corners[i] + window.sizes[i]);
    return out;
}

/// The drawing in a part of the window.
class Canvas {
public:
    Canvas(ViewModel& model, const GraphFacts& graph, void* insets, GraphWindow& window, float scale)
        : model_(model), graph_(graph), insets_(insets), window_(window), scale_(scale),
          list_(*ImGui::GetWindowDrawList())
    {
        const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
        from_ = window.canvas = {at.x, at.y};
        size_ = glm::max(vec2(room.x, room.y), vec2(1));
        for (const GraphPassFacts& pass : graph.passes) costliest_ = std::max(costliest_, pass.gpu_ms);
    }

    /// All of it, or, `readable`, as much as can still be read, from the left.
    void fit(bool readable)
    {
        const vec2 all = extent(window_), room = size_ - 2 * margin * scale_;
        const float least = readable ? 0.7f : smallest_zoom;
        const float whole = readable ? room.y / all.y : std::min(room.x / all.x, room.y / all.y);
        window_.zoom = std::clamp(whole, least, 1.0f);
        const vec2 left = size_ - window_.zoom * all;
        window_.origin = {std::max(0.5f * left.x, margin * scale_), 0.5f * left.y};
    }

    void draw()
    {
        if (window_.zoom == 0) fit(true);
        ImGui::InvisibleButton("canvas", im(size_),
                               ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
        const bool hovered = ImGui::IsItemHovered();
        if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
            window_.origin += vec2(ImGui::GetIO().MouseDelta.x, ImGui::GetIO().MouseDelta.y);
        const vec2 mouse(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
        if (hovered) zoom_at(mouse, ImGui::GetIO().MouseWheel);
        pointed_ = hovered ? box_at(mouse) : none;

        list_.PushClipRect(im(from_), im(from_ + size_), true);
        for (const bool marked : {false, true}) {
            for (const GraphLine& line : window_.drawing.lines) {
                if (is_marked(line) == marked) draw_line(line, marked);
            }
        }
        for (std::size_t i = 0; i < window_.drawing.boxes.size(); ++i) draw_box(i);
        list_.PopClipRect();
        window_.pointed.clear();
        if (pointed_ == none) return;
        window_.pointed = key_of(graph_, window_.drawing.boxes[pointed_]);
        window_.pointed_at = window_.corners[pointed_];
        draw_graph_tip(graph_, window_.drawing.boxes[pointed_]);
        act_on(window_.drawing.boxes[pointed_]);
    }

private:
    [[nodiscard]] vec2 screen(const vec2& at) const { return from_ + window_.origin + window_.zoom * at; }

    void zoom_at(const vec2& mouse, float wheel)
    {
        if (wheel == 0) return;
        const float before = window_.zoom;
        window_.zoom = std::clamp(before * std::pow(1.15f, wheel), smallest_zoom, largest_zoom);
        const vec2 to_mouse = mouse - from_ - window_.origin; // stays under the mouse
        window_.origin += to_mouse * (1 - window_.zoom / before);
    }

    [[nodiscard]] std::size_t box_at(const vec2& mouse) const
    {
        for (std::size_t i = 0; i < window_.corners.size(); ++i) {
            const vec2 low = screen(window_.corners[i]), high = low + window_.zoom * window_.sizes[i];
            if (glm::all(glm::lessThanEqual(low, mouse)) && glm::all(glm::lessThan(mouse, high))) return i;
        }
        return none;
    }

    [[nodiscard]] bool is_marked(const GraphLine& line) const { return line.from == pointed_ || line.to == pointed_; }

    /// Whether it belongs to what the mouse points at, which is the case of everything where that is nothing.
    [[nodiscard]] bool is_near(std::size_t box) const
    {
        const auto joins = [&](const GraphLine& l) { return is_marked(l) && (l.from == box || l.to == box); };
        const std::vector<GraphLine>& lines = window_.drawing.lines;
        return pointed_ == none || pointed_ == box || std::any_of(lines.begin(), lines.end(), joins);
    }

    /// From the right side of one box to the left side of the other: red from who writes, grey to who reads.
    void draw_line(const GraphLine& line, bool marked)
    {
        const vec2 a = screen(window_.corners[line.from] + window_.sizes[line.from] * vec2(1, 0.5f));
        const vec2 b = screen(window_.corners[line.to] + window_.sizes[line.to] * vec2(0, 0.5f));
        const vec2 low = glm::min(a, b), high = glm::max(a, b);
        if (glm::any(glm::greaterThan(low, from_ + size_)) || glm::any(glm::lessThan(high, from_))) return;
        const bool writes = window_.drawing.boxes[line.to].image.has_value();
        const float alpha = marked ? 1.0f : pointed_ == none ? 0.35f : 0.1f;
        const ImU32 color = ImGui::GetColorU32(writes ? ImGuiCol_SliderGrabActive : ImGuiCol_TextDisabled, alpha);
        const vec2 bend(0.5f * (b.x - a.x), 0);
        list_.AddBezierCubic(im(a), im(a + bend), im(b - bend), im(b), color, (marked ? 2.0f : 1.0f) * scale_, 20);
    }

    void draw_box(std::size_t index)
    {
        const GraphBox& box = window_.drawing.boxes[index];
        const vec2 low = screen(window_.corners[index]), high = low + window_.zoom * window_.sizes[index];
        if (glm::any(glm::greaterThan(low, from_ + size_)) || glm::any(glm::lessThan(high, from_))) return;
        const float alpha = is_near(index) ? 1.0f : 0.35f, rounding = (box.image ? 8.0f : 2.0f) * window_.zoom * scale_;
        const bool shown = box.image && is_shown(*box.image);
        const ImU32 edge = ImGui::GetColorU32(shown || pointed_ == index ? ImGuiCol_CheckMark : ImGuiCol_Border, alpha);
        list_.AddRectFilled(im(low), im(high), ImGui::GetColorU32(box.image ? ImGuiCol_PopupBg : ImGuiCol_FrameBg),
                            rounding);
        list_.AddRect(im(low), im(high), edge, rounding, 0, (shown ? 2.0f : 1.0f) * scale_);
        vec2 text = low + window_.zoom * padding * scale_;
        if (box.image)
            text.x += draw_thumbnail(*box.image, text, alpha);
        else
            draw_share(box, low, high, alpha);
        draw_text(text, title_of(graph_, box), ImGui::GetColorU32(ImGuiCol_Text, alpha));
        text.y += window_.zoom * ImGui::GetFontSize();
        draw_text(text, subtitle_of(graph_, box), ImGui::GetColorU32(ImGuiCol_TextDisabled, alpha));
    }

    void draw_text(const vec2& at, const std::string& text, ImU32 color)
    {
        const float height = window_.zoom * ImGui::GetFontSize();
        constexpr float legible = 4; // pixels
        if (height >= legible) list_.AddText(ImGui::GetFont(), height, im(at), color, text.c_str());
    }

    /// Along the foot of a pass: its time beside the dearest one's.
    void draw_share(const GraphBox& box, const vec2& low, const vec2& high, float alpha)
    {
        if (costliest_ <= 0) return;
        const float share = static_cast<float>(std::min(gpu_ms(graph_, box) / costliest_, 1.0));
        const float height = 3 * window_.zoom * scale_;
        list_.AddRectFilled({low.x, high.y - height}, {low.x + share * (high.x - low.x), high.y},
                            ImGui::GetColorU32(ImGuiCol_SliderGrab, alpha));
    }

    /// What a pinned image holds, an empty frame of another. Returns how much room it takes.
    float draw_thumbnail(std::size_t image, const vec2& at, float alpha)
    {
        const vec2 size = window_.zoom * scale_ * thumbnail;
        const std::string name = buffer_of(graph_.resources[image]);
        const auto pin = std::find_if(model_.pinned.begin(), model_.pinned.end(),
                                      [&](const PinnedBuffer& p) { return p.name == name; });
        list_.AddRectFilled(im(at), im(at + size), ImGui::GetColorU32(ImGuiCol_FrameBg, alpha));
        if (pin != model_.pinned.end()) {
            const auto count = static_cast<float>(model_.pinned.size());
            const auto first = static_cast<float>(pin - model_.pinned.begin());
            list_.AddImage(insets_, im(at), im(at + size), {first / count, 0}, {(first + 1) / count, 1});
        }
        return size.x + window_.zoom * padding * scale_;
    }

    [[nodiscard]] bool is_shown(std::size_t image) const
    {
        const std::string name = buffer_of(graph_.resources[image]);
        const auto is_it = [&](const PinnedBuffer& p) { return p.name == name; };
        return model_.settings.debug.view == name || std::any_of(model_.pinned.begin(), model_.pinned.end(), is_it);
    }

    void act_on(const GraphBox& box)
    {
        if (!box.image) return;
        const std::string name = buffer_of(graph_.resources[*box.image]);
        const auto clicked = [](ImGuiMouseButton button) {
            const ImGuiIO& io = ImGui::GetIO();
            const float still = io.MouseDragThreshold * io.MouseDragThreshold;
            return ImGui::IsMouseReleased(button) && io.MouseDragMaxDistanceSqr[button] < still;
        };
        if (clicked(ImGuiMouseButton_Left)) model_.toggle_pin(name);
        std::string& view = model_.settings.debug.view;
        if (clicked(ImGuiMouseButton_Right)) view = view == name ? "" : name;
    }

    ViewModel& model_;
    const GraphFacts& graph_;
    void* insets_;
    GraphWindow& window_;
    float scale_;
    ImDrawList& list_;
    vec2 from_{0}, size_{0};     ///< on the screen
    double costliest_ = 0;       ///< ms of a pass
    std::size_t pointed_ = none; ///< box under the mouse
};

} // namespace

void draw_graph_window(ViewModel& model, const GraphFacts& graph, void* insets, GraphWindow& window, float scale)
{
    if (!window.open) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float left = std::min(panel_end * scale, 0.5f * display.x), edge = margin * scale;
    ImGui::SetNextWindowPos({left, edge}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({display.x - left - edge, 0.58f * display.y}, ImGuiCond_FirstUseEver); // above the insets
    ImGui::SetNextWindowSizeConstraints({240 * scale, 160 * scale}, {display.x, display.y});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                                       ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    if (ImGui::Begin("Frame graph", &window.open, flags)) {
        const bool whole = ImGui::Button("whole");
        ImGui::SameLine();
        const bool readable = ImGui::Button("readable");
        ImGui::SameLine();
        ImGui::TextDisabled("%s", summary_of(graph).c_str());
        lay_out(graph, window, scale);
        Canvas canvas(model, graph, insets, window, scale);
        if (whole || readable) canvas.fit(readable);
        canvas.draw();
    }
    ImGui::End();
}

} // namespace atrium::gui
