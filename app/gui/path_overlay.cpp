#include "app/gui/path_overlay.hpp"

#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

constexpr ImU32 curve_color = IM_COL32(238, 176, 84, 255), look_color = IM_COL32(245, 235, 220, 255);
constexpr ImU32 mark_edge = IM_COL32(20, 18, 16, 220);
// In pixels at scale 1.
constexpr float mark_radius = 5, look_length = 28, width = 2;

ImVec2 to_im(vec2 v)
{
    return {v.x, v.y};
}

void draw_line(const vec3& a, const vec3& b, ImU32 color, const Projection& view, float scale)
{
    const auto from = view.project(a), to = view.project(b);
    if (from && to) ImGui::GetBackgroundDrawList()->AddLine(to_im(*from), to_im(*to), color, width * scale);
}

void draw_curve(const CameraPath& path, const Projection& view, float scale)
{
    constexpr int steps = 24; // between two keys
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        vec3 before = path[i].eye;
        for (int step = 1; step <= steps; ++step) {
            const double time = path[i].time + (path[i + 1].time - path[i].time) * step / steps;
            const vec3 now = camera_at(path, time, Camera{}).eye;
            draw_line(before, now, curve_color, view, scale);
            before = now;
        }
    }
}

void draw_mark(const CameraKey& key, bool bright, const Projection& view, float scale)
{
    const auto at = view.project(key.eye);
    if (!at) return;
    const vec3 look = look_length * scale * view.pixel_size(key.eye) * glm::normalize(key.target - key.eye);
    draw_line(key.eye, key.eye + look, look_color, view, scale);
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddCircleFilled(to_im(*at), mark_radius * scale, bright ? IM_COL32_WHITE : curve_color);
    draw.AddCircle(to_im(*at), mark_radius * scale, mark_edge, 0, 1.5f * scale);
}

} // namespace

void draw_path(const CameraPath& path, std::optional<std::size_t> selected, const Projection& view, float scale)
{
    draw_curve(path, view, scale);
    for (std::size_t i = 0; i < path.size(); ++i) draw_mark(path[i], selected == i, view, scale);
}

} // namespace atrium::gui
