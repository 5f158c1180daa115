#include "assetconv/courtyard/shapes.hpp"

#include <algorithm>
#include <array>

namespace atrium::courtyard {
namespace {

/// The six faces by axis and sign; the order of BoxFace's bits.
struct Face {
    int axis;
    float sign;
};
constexpr std::array<Face, 6> faces{{{0, -1}, {0, 1}, {1, -1}, {1, 1}, {2, -1}, {2, 1}}};

struct Shape {
    vec3 centre, half;
    float cut;
    int long_axis; // -1: plain
};

/// Corner (signs) of the box as the face of `axis` has it: on the face, drawn in by the chamfer along both others.
vec3 corner(const Shape& s, vec3 signs, int axis)
{
    vec3 p = s.half - vec3(s.cut);
    p[axis] = s.half[axis];
    return s.centre + signs * p;
}

vec3 normal_of(int axis, float sign)
{
    vec3 n(0);
    n[axis] = sign;
    return n;
}

/// Texture plane of a face: metres along the two other axes, mirrored so that it reads the right way from outside.
vec2 project(const Shape& s, const vec3& p, int axis, float sign)
{
    vec2 uv;
    if (axis == 0) {
        uv = {-sign * p.z, p.y};
    }
    if (axis == 1) {
        uv = {p.x, -sign * p.z};
    }
    if (axis == 2) {
        uv = {sign * p.x, p.y};
    }
    const bool turn = (s.long_axis == 1 && axis != 1) || (s.long_axis == 2 && axis == 1);
    return turn ? vec2(uv.y, -uv.x) : uv;
}

std::uint32_t put(Pen& pen, const Shape& s, vec3 signs, int axis, Face texture)
{
    const vec3 p = corner(s, signs, axis);
    return pen.add(p, normal_of(axis, signs[axis]), project(s, p, texture.axis, texture.sign));
}

void draw_face(Pen& pen, const Shape& s, Face f)
{
    const int a = (f.axis + 1) % 3, b = (f.axis + 2) % 3;
    std::array<std::uint32_t, 4> id{};
    for (int i = 0; i < 4; ++i) {
        vec3 signs(f.sign);
        signs[a] = (i == 0 || i == 3) ? -1.0f : 1.0f;
        signs[b] = i < 2 ? -1.0f : 1.0f;
        id[static_cast<std::size_t>(i)] = put(pen, s, signs, f.axis, f);
    }
    pen.quad(id[0], id[1], id[2], id[3]);
}

void draw_edge(Pen& pen, const Shape& s, Face f, Face g)
{
    const int along = 3 - f.axis - g.axis;
    vec3 start(0);
    start[f.axis] = f.sign;
    start[g.axis] = g.sign;
    start[along] = -1;
    vec3 end = start;
    end[along] = 1;
    pen.quad(put(pen, s, start, f.axis, f), put(pen, s, end, f.axis, f), put(pen, s, end, g.axis, f),
             put(pen, s, start, g.axis, f));
}

} // namespace

void draw_box(Pen& pen, const Box& box)
{
    Shape s{0.5f * (box.low + box.high), 0.5f * (box.high - box.low), 0, -1};
    s.cut = std::min(box.chamfer < pen.least_chamfer() ? 0.0f : box.chamfer,
                     0.45f * std::min({s.half.x, s.half.y, s.half.z}));
    if (box.grain) {
        s.long_axis = s.half.x >= s.half.y && s.half.x >= s.half.z ? 0 : (s.half.y >= s.half.z ? 1 : 2);
    }
    const auto has = [&](std::size_t i) { return (box.without >> i & 1u) == 0; };
    for (std::size_t i = 0; i < 6; ++i) {
        if (has(i)) {
            draw_face(pen, s, faces[i]);
        }
        for (std::size_t j = i + 1; j < 6; ++j) {
            if (faces[i].axis != faces[j].axis && has(i) && has(j)) {
                draw_edge(pen, s, faces[i], faces[j]);
            }
        }
    }
    for (unsigned c = 0; c < 8; ++c) {
        const bool x = (c & 1u) != 0, y = (c & 2u) != 0, z = (c & 4u) != 0;
        if (!has(x ? 1 : 0) || !has(y ? 3 : 2) || !has(z ? 5 : 4)) {
            continue;
        }
        const vec3 signs(x ? 1 : -1, y ? 1 : -1, z ? 1 : -1);
        const Face texture{0, signs.x};
        pen.triangle(put(pen, s, signs, 0, texture), put(pen, s, signs, 1, texture), put(pen, s, signs, 2, texture));
    }
}

} // namespace atrium::courtyard
