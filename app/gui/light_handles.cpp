#include "app/gui/light_handles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

// In pixels at scale 1.
constexpr float mark_radius = 6, handle_radius = 5, reach = 9; // reach: of the mouse
constexpr float axis_length = 56, aim_length = 110, beside = 18;

constexpr std::array axes{vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)};

bool stands_somewhere(const Light& light)
{
    return light.type != LightType::sun;
}

/// A unit vector across the light's direction that is well seen.
vec3 across(const Light& light, const Projection& view)
{
    const vec3 direction = glm::normalize(light.direction);
    const vec3 seen = glm::cross(direction, view.forward);
    return glm::length(seen) > 0.05f ? glm::normalize(seen) : axes_of(light).right;
}

float angle_between(const vec3& a, const vec3& b)
{
    return glm::degrees(std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0f, 1.0f)));
}

ImVec2 to_im(vec2 v)
{
    return {v.x, v.y};
}

ImU32 color_of(HandleKind kind)
{
    switch (kind) {
    case HandleKind::along_x:
        return IM_COL32(226, 86, 76, 255);
    case HandleKind::along_y:
        return IM_COL32(120, 200, 90, 255);
    case HandleKind::along_z:
        return IM_COL32(90, 140, 235, 255);
    case HandleKind::outer:
    case HandleKind::inner:
        return IM_COL32(238, 176, 84, 255);
    default:
        return IM_COL32(245, 235, 220, 255);
    }
}

const char* name_of(HandleKind kind, LightType type)
{
    switch (kind) {
    case HandleKind::along_x:
        return "move along x";
    case HandleKind::along_y:
        return "move along y";
    case HandleKind::along_z:
        return "move along z";
    case HandleKind::aim:
        return "direction";
    case HandleKind::outer:
        return "outer angle";
    case HandleKind::inner:
        return "inner angle";
    case HandleKind::extent:
        return type == LightType::rect ? "width" : "size";
    case HandleKind::extent_up:
        return "height";
    case HandleKind::place: // the light's mark, with the light's name
        break;
    }
    return "";
}

void draw_dot(vec2 at, float radius, ImU32 fill, bool bright)
{
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddCircleFilled(to_im(at), radius, fill);
    draw.AddCircle(to_im(at), radius, bright ? IM_COL32_WHITE : IM_COL32(20, 18, 16, 220), 0, bright ? 2.0f : 1.5f);
}

/// A light's own hue, as bright as can be.
ImU32 mark_color(const Light& light)
{
    const vec3 c = light.color / std::max({light.color.x, light.color.y, light.color.z, 1e-6f});
    return ImGui::ColorConvertFloat4ToU32({std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z), 1.0f});
}

/// A sphere's silhouette, a rectangle's sides.
void draw_outline(const Light& light, const Projection& view)
{
    std::vector<vec3> corners;
    if (light.type == LightType::rect) {
        const LightAxes own = axes_of(light);
        const vec3 x = 0.5f * light.width * own.right, y = 0.5f * light.height * own.up;
        corners = {x + y, y - x, -x - y, x - y};
    } else if (stands_somewhere(light)) {
        constexpr int count = 48;
        for (int i = 0; i < count; ++i) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / count;
            corners.push_back(light.size * (std::cos(turn) * view.right + std::sin(turn) * view.up));
        }
    }
    std::vector<ImVec2> line;
    for (const vec3& corner : corners) {
        const auto at = view.project(light.position + corner);
        if (!at) return;
        line.push_back(to_im(*at));
    }
    ImGui::GetBackgroundDrawList()->AddPolyline(line.data(), static_cast<int>(line.size()),
                                                color_of(HandleKind::extent), ImDrawFlags_Closed, 1.5f);
}

void draw_handle(const Handle& handle, const Projection& view, float scale, bool bright)
{
    const auto from = view.project(handle.from), at = view.project(handle.at);
    if (!from || !at) return;
    if (handle.kind == HandleKind::place) return; // the light's mark
    ImGui::GetBackgroundDrawList()->AddLine(to_im(*from), to_im(*at), color_of(handle.kind), 2.0f * scale);
    draw_dot(*at, handle_radius * scale, color_of(handle.kind), bright);
}

} // namespace

std::vector<Handle> handles_of(const Light& light, const Projection& view, float scale)
{
    // A sun's are before the camera, in the upper half of the picture.
    const vec3 middle = stands_somewhere(light) ? light.position : view.eye + 2.0f * view.forward + 0.3f * view.up;
    const float pixel = scale * view.pixel_size(middle);
    const LightAxes own = axes_of(light);
    std::vector<Handle> handles;
    const auto add = [&](HandleKind kind, const vec3& to) { handles.push_back({kind, middle, middle + to}); };

    if (stands_somewhere(light)) {
        add(HandleKind::place, vec3(0));
        add(HandleKind::along_x, axis_length * pixel * axes[0]);
        add(HandleKind::along_y, axis_length * pixel * axes[1]);
        add(HandleKind::along_z, axis_length * pixel * axes[2]);
    }
    const vec3 aim = aim_length * pixel * own.direction;
    if (light.type != LightType::point) add(HandleKind::aim, aim);
    if (light.type == LightType::spot) {
        const vec3 side = aim_length * pixel * across(light, view);
        for (const HandleKind kind : {HandleKind::outer, HandleKind::inner}) {
            const float angle = glm::radians(kind == HandleKind::outer ? light.outer : light.inner);
            add(kind, std::cos(angle) * aim + (kind == HandleKind::outer ? 1.0f : -1.0f) * std::sin(angle) * side);
        }
    }
    if (light.type == LightType::rect) {
        add(HandleKind::extent, 0.5f * light.width * own.right);
        add(HandleKind::extent_up, 0.5f * light.height * own.up);
    } else if (stands_somewhere(light)) {
        add(HandleKind::extent, -(light.size + beside * pixel) * view.right);
    }
    return handles;
}

Light dragged(const Light& light, const Handle& handle, const Projection& view, vec2 pixels)
{
    const vec3 moved = view.in_view_plane(handle.at, pixels);
    const vec3 before = handle.at - handle.from, now = before + moved;
    const auto angle = [&](float old) { // by how much the handle has turned away from the axis
        return std::clamp(old + angle_between(now, light.direction) - angle_between(before, light.direction), 0.1f,
                          80.0f);
    };
    constexpr float least = 1e-3f; // m
    Light out = light;
    switch (handle.kind) {
    case HandleKind::place:
        out.position += moved;
        break;
    case HandleKind::along_x:
    case HandleKind::along_y:
    case HandleKind::along_z: {
        // As far along the axis as the mouse went along the axis's image.
        const vec3 axis = axes[static_cast<std::size_t>(handle.kind) - static_cast<std::size_t>(HandleKind::along_x)];
        const vec2 image(glm::dot(axis, view.right), -glm::dot(axis, view.up));
        const float length2 = glm::dot(image, image);
        if (length2 > 1e-3f) out.position += axis * (view.pixel_size(handle.at) * glm::dot(pixels, image) / length2);
        break;
    }
    case HandleKind::aim:
        if (glm::length(now) > 1e-6f) out.direction = glm::normalize(now);
        break;
    case HandleKind::outer:
        out.outer = angle(light.outer);
        out.inner = std::min(out.inner, out.outer);
        break;
    case HandleKind::inner:
        out.inner = std::min(angle(light.inner), out.outer);
        break;
    case HandleKind::extent:
        if (light.type == LightType::rect)
            out.width = std::max(2 * glm::dot(now, glm::normalize(before)), least);
        else
            out.size = std::max(light.size + glm::dot(moved, glm::normalize(before)), least);
        break;
    case HandleKind::extent_up:
        out.height = std::max(2 * glm::dot(now, glm::normalize(before)), least);
        break;
    }
    return out;
}

void LightHandles::follow(ViewModel& model, const Projection& view, vec2 mouse)
{
    const bool down = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    const bool still_there = held_ && model.selected && *model.selected < model.lights.size() &&
                             model.lights[*model.selected].name == held_->light.name;
    if (!down || !still_there) held_.reset();
    if (!held_) return;
    const Light wanted = dragged(held_->light, held_->handle, view, mouse - held_->mouse);
    static_cast<void>(model.set_light(*model.selected, wanted));
}

bool LightHandles::update(ViewModel& model, float scale)
{
    const ImGuiIO& io = ImGui::GetIO();
    const Projection view(model.camera, {io.DisplaySize.x, io.DisplaySize.y});
    const vec2 mouse(io.MousePos.x, io.MousePos.y);
    follow(model, view, mouse);
    // A drag that began elsewhere turns the view, and with Ctrl moves a light, wherever it comes by.
    const bool pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    const bool down = ImGui::IsMouseDown(ImGuiMouseButton_Left) || ImGui::IsMouseDown(ImGuiMouseButton_Right);
    const bool listens = !held_ && !io.WantCaptureMouse && !io.KeyCtrl && (pressed || !down);
    bool touched = held_.has_value();
    const auto pointed_at = [&](const vec3& point, const char* name) {
        const auto at = view.project(point);
        const bool pointed = listens && at && glm::distance(*at, mouse) < reach * scale;
        if (pointed) ImGui::SetTooltip("%s", name);
        touched = touched || pointed;
        return pointed;
    };

    for (std::size_t i = 0; i < model.lights.size(); ++i) {
        const Light& light = model.lights[i];
        const auto at = view.project(light.position);
        if (!stands_somewhere(light) || !at) continue;
        if (pointed_at(light.position, light.name.c_str()) && pressed) model.selected = i;
        draw_dot(*at, mark_radius * scale, mark_color(light), model.selected == i);
    }
    if (!model.selected || *model.selected >= model.lights.size()) return touched;

    const Light& light = model.lights[*model.selected];
    draw_outline(light, view);
    for (const Handle& handle : handles_of(light, view, scale)) {
        const bool is_mark = handle.kind == HandleKind::place;
        const bool pointed = pointed_at(handle.at, is_mark ? light.name.c_str() : name_of(handle.kind, light.type));
        draw_handle(handle, view, scale, pointed || (held_ && held_->handle.kind == handle.kind));
        if (pointed && pressed) held_ = Held{light, handle, mouse};
    }
    return touched;
}

} // namespace atrium::gui
