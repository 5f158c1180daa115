#include "assetconv/courtyard/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {

void draw_plane(Pen& pen, vec3 origin, vec3 edge_u, vec3 edge_v, int pieces_u, int pieces_v, vec2 uv_origin)
{
    const vec3 normal = glm::normalize(glm::cross(edge_u, edge_v));
    const float length_u = glm::length(edge_u), length_v = glm::length(edge_v);
    std::uint32_t previous = 0;
    for (int j = 0; j <= pieces_v; ++j) {
        const float t = static_cast<float>(j) / static_cast<float>(pieces_v);
        std::uint32_t row = 0;
        for (int i = 0; i <= pieces_u; ++i) {
            const float s = static_cast<float>(i) / static_cast<float>(pieces_u);
            const std::uint32_t id =
                pen.add(origin + s * edge_u + t * edge_v, normal, uv_origin + vec2(s * length_u, t * length_v));
            if (i == 0) {
                row = id;
            }
        }
        if (j > 0) {
            pen.strip(previous, row, static_cast<std::uint32_t>(pieces_u + 1));
        }
        previous = row;
    }
}

namespace {

vec3 sheet_normal(const Sheet& sheet, float s, float t)
{
    constexpr float step = 2e-3f;
    const float s0 = std::max(0.0f, s - step), s1 = std::min(1.0f, s + step);
    const float t0 = std::max(0.0f, t - step), t1 = std::min(1.0f, t + step);
    const vec3 along_s = sheet.at(s1, t).position - sheet.at(s0, t).position;
    const vec3 along_t = sheet.at(s, t1).position - sheet.at(s, t0).position;
    return glm::normalize(glm::cross(along_s, along_t));
}

/// Rows of corners of one face of the sheet; returns the first corner.
std::uint32_t sheet_face(Pen& pen, const Sheet& sheet, float side, float back_by)
{
    const int columns = sheet.pieces_s + 1;
    std::uint32_t first = 0;
    for (int j = 0; j <= sheet.pieces_t; ++j) {
        for (int i = 0; i < columns; ++i) {
            const float s = static_cast<float>(i) / static_cast<float>(sheet.pieces_s);
            const float t = static_cast<float>(j) / static_cast<float>(sheet.pieces_t);
            const SheetPoint p = sheet.at(s, t);
            const vec3 n = sheet_normal(sheet, s, t);
            const std::uint32_t id = pen.add(p.position - back_by * n, side * n, p.uv);
            if (i == 0 && j == 0) {
                first = id;
            }
        }
    }
    for (int j = 0; j < sheet.pieces_t; ++j) {
        const auto row = first + static_cast<std::uint32_t>(j * columns);
        pen.strip(row, row + static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(columns));
    }
    return first;
}

/// Closes the gap between front and back along one edge of the sheet.
void sheet_rim(Pen& pen, const Sheet& sheet, bool along_s, float edge)
{
    const int pieces = along_s ? sheet.pieces_s : sheet.pieces_t;
    const float inwards = edge < 0.5f ? 0.01f : -0.01f;
    std::uint32_t previous = 0;
    for (int i = 0; i <= pieces; ++i) {
        const float x = static_cast<float>(i) / static_cast<float>(pieces);
        const float s = along_s ? x : edge, t = along_s ? edge : x;
        const SheetPoint p = sheet.at(s, t);
        const vec3 n = sheet_normal(sheet, s, t);
        const SheetPoint inner = along_s ? sheet.at(s, t + inwards) : sheet.at(s + inwards, t);
        const vec3 away = p.position - inner.position;
        const vec3 outwards = glm::normalize(away - n * glm::dot(away, n));
        const std::uint32_t id = pen.add(p.position, outwards, p.uv);
        pen.add(p.position - sheet.thickness * n, outwards, p.uv + vec2(sheet.thickness));
        if (i > 0) {
            pen.strip(previous, id, 2);
        }
        previous = id;
    }
}

} // namespace

void draw_sheet(Pen& pen, const Sheet& sheet)
{
    sheet_face(pen, sheet, 1, 0);
    if (sheet.thickness <= 0) {
        return;
    }
    sheet_face(pen, sheet, -1, sheet.thickness);
    if (!sheet.rims) {
        return;
    }
    for (const float edge : {0.0f, 1.0f}) {
        sheet_rim(pen, sheet, true, edge);
        sheet_rim(pen, sheet, false, edge);
    }
}

void draw_rod(Pen& pen, vec3 from, vec3 to, float radius_from, float radius_to, int segments)
{
    const float length = glm::length(to - from);
    const vec3 y = (to - from) / length;
    const vec3 x = glm::normalize(std::abs(y.y) < 0.9f ? glm::cross(y, vec3(0, 1, 0)) : glm::cross(y, vec3(1, 0, 0)));
    Pen local = pen.moved(frame_of(x, y, glm::cross(x, y), from));
    draw_lathe(local, ProfilePath({radius_from, 0}, Cut{2}).to(radius_to, length).finish(0), {.segments = segments});
}

void draw_ring(Pen& pen, vec3 centre, float radius, float thickness, int segments, int around)
{
    Sheet sheet{.pieces_s = segments, .pieces_t = around, .thickness = 0, .rims = false, .at = {}};
    sheet.at = [=](float s, float t) {
        const float a = 2 * pi * s, b = 2 * pi * t;
        const float r = radius + thickness * std::cos(b);
        return SheetPoint{centre + vec3(r * std::cos(a), r * std::sin(a), thickness * std::sin(b)),
                          {a * radius, b * thickness}};
    };
    draw_sheet(pen, sheet);
}

void draw_ball(Pen& pen, vec3 centre, float radius, int segments)
{
    Pen local = pen.moved(moved_to(centre));
    ProfilePath path({0, -radius}, Cut{std::max(2, segments / 3)});
    path.ovolo(radius, radius).cavetto(-radius, radius);
    draw_lathe(local, path.finish(0), {.segments = segments});
}

} // namespace atrium::courtyard
