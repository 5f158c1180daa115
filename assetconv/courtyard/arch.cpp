#include "assetconv/courtyard/arch.hpp"

#include <array>

namespace atrium::courtyard {
namespace {

vec3 on(const ArchShape& arch, float angle, float beyond, float z)
{
    return vec3(arch.at(angle, beyond), z);
}

/// Texture coordinates that follow the arch.
vec2 along(const ArchShape& arch, float angle, float across)
{
    return {angle * arch.radius(), across};
}

} // namespace

void draw_pierced_wall(Pen& pen, const ArchShape& arch, const PiercedWall& wall, int segments)
{
    const vec3 normal(0, 0, 1);
    const float extent = arch.extent();
    std::uint32_t previous = 0;
    // Columns of three corners from the opening's edge to the top; the first and last stand on the springing line.
    for (int i = -2; i <= segments + 2; ++i) {
        const int k = std::min(std::max(i, 0), segments);
        const float angle = extent * (2 * static_cast<float>(k) / static_cast<float>(segments) - 1);
        vec2 low = arch.at(angle, wall.margin);
        if (i < 0 || i > segments) {
            low.y = 0;
        }
        if (i == -2) {
            low.x = wall.left;
        }
        if (i == segments + 2) {
            low.x = wall.right;
        }
        low.y = std::max(low.y, 0.0f);
        const std::array<vec2, 2> ends{low, vec2(low.x, wall.top)};
        std::uint32_t id = 0;
        for (std::size_t j = 0; j < 2; ++j) {
            const std::uint32_t corner = pen.add(vec3(ends[j], wall.z), normal, wall.uv_origin + ends[j]);
            if (j == 0) {
                id = corner;
            }
        }
        if (i > -2) {
            pen.strip(previous, id, 2);
        }
        previous = id;
    }
}

void draw_soffit(Pen& pen, const ArchShape& arch, float back, float front, int segments)
{
    std::uint32_t previous = 0;
    for (int i = 0; i <= segments; ++i) {
        const float angle = arch.extent() * (2 * static_cast<float>(i) / static_cast<float>(segments) - 1);
        const vec3 normal(-arch.outwards(angle), 0);
        const std::uint32_t id = pen.add(on(arch, angle, 0, back), normal, along(arch, angle, back));
        pen.add(on(arch, angle, 0, front), normal, along(arch, angle, front));
        if (i > 0) {
            pen.strip(previous, id, 2);
        }
        previous = id;
    }
}

namespace {

/// One stone between two angles: its face, and the chamfers that lead down to the joints and the soffit. Its upper edge
/// lies under the archivolt.
void draw_voussoir(Pen& pen, const ArchShape& arch, const VoussoirRing& ring, float from, float to)
{
    const float cut = ring.chamfer, turn = cut / arch.radius();
    const float face = ring.z + ring.proud, side = face - cut;
    const vec3 forwards(0, 0, 1);
    struct Row {
        std::uint32_t soffit, inner, outer;
    };
    const auto row = [&](float angle) {
        const vec3 out(arch.outwards(angle), 0);
        Row r{};
        r.soffit = pen.add(on(arch, angle, 0, side), -out, along(arch, angle, -cut));
        r.inner = pen.add(on(arch, angle, cut, face), forwards, along(arch, angle, 0));
        r.outer = pen.add(on(arch, angle, ring.depth, face), forwards, along(arch, angle, ring.depth));
        return r;
    };
    Row previous{};
    for (int i = 0; i <= ring.segments; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(ring.segments);
        const Row now = row(from + turn + (to - from - 2 * turn) * share);
        if (i > 0) {
            pen.quad(previous.soffit, now.soffit, now.inner, previous.inner);
            pen.quad(previous.inner, now.inner, now.outer, previous.outer);
        }
        previous = now;
    }
    for (const float end : {-1.0f, 1.0f}) { // chamfers into the joints
        const float edge = end < 0 ? from : to, inside = edge - end * turn;
        const vec2 out = arch.outwards(edge);
        const vec3 sideways(end * out.y, -end * out.x, 0);
        const std::uint32_t a = pen.add(on(arch, inside, cut, face), forwards, along(arch, inside, 0));
        const std::uint32_t b = pen.add(on(arch, inside, ring.depth, face), forwards, along(arch, inside, ring.depth));
        const std::uint32_t c = pen.add(on(arch, edge, ring.depth, side), sideways, along(arch, edge, ring.depth));
        const std::uint32_t d = pen.add(on(arch, edge, cut, side), sideways, along(arch, edge, 0));
        pen.quad(a, b, c, d);
        const std::uint32_t e = pen.add(on(arch, inside, 0, side), vec3(-out, 0), along(arch, inside, -cut));
        const auto flat = [&](float angle, float beyond) {
            return pen.add(on(arch, angle, beyond, side), forwards, along(arch, angle, beyond));
        };
        pen.triangle(flat(inside, 0), flat(edge, cut), flat(edge, 0));
        pen.triangle(a, d, e);
    }
}

} // namespace

void draw_voussoirs(Pen& pen, const ArchShape& arch, const VoussoirRing& ring)
{
    const float step = 2 * arch.extent() / static_cast<float>(ring.stones);
    for (int i = 0; i < ring.stones; ++i) {
        if (ring.keystone && i == ring.stones / 2) {
            continue;
        }
        const float from = -arch.extent() + step * static_cast<float>(i);
        pen.set_uv_offset({0.37f * static_cast<float>(i), 0.53f * static_cast<float>(i)});
        draw_voussoir(pen, arch, ring, from, from + step);
    }
    pen.set_uv_offset(vec2(0));
}

void draw_archivolt(Pen& pen, const ArchShape& arch, const Profile& profile, float z, int segments)
{
    std::uint32_t previous = 0;
    for (int i = 0; i <= segments; ++i) {
        const float angle = arch.extent() * (2 * static_cast<float>(i) / static_cast<float>(segments) - 1);
        std::uint32_t row = 0;
        for (std::size_t j = 0; j < profile.size(); ++j) {
            const ProfilePoint& p = profile[j];
            const vec3 normal(arch.outwards(angle) * p.normal.y, p.normal.x);
            const std::uint32_t id = pen.add(on(arch, angle, p.at.y, z + p.at.x), normal, along(arch, angle, p.length));
            if (j == 0) {
                row = id;
            }
        }
        if (i > 0) {
            pen.strip(previous, row, static_cast<std::uint32_t>(profile.size()));
        }
        previous = row;
    }
}

void draw_keystone(Pen& pen, const ArchShape& arch, float depth, float half_angle, float back, float front)
{
    // A tapered block, its face drawn in by a chamfer; the back is in the wall.
    const float low = arch.rise - 0.03f, high = arch.rise + depth, cut = 0.014f;
    const float low_half = arch.radius() * std::sin(half_angle),
                high_half = low_half * (1 + depth / arch.radius()) + 0.015f;
    const std::array<vec2, 4> face{vec2(-low_half, low), vec2(low_half, low), vec2(high_half, high),
                                   vec2(-high_half, high)};
    const std::array<vec2, 4> inset{vec2(cut, cut), vec2(-cut, cut), vec2(-cut, -cut), vec2(cut, -cut)};
    std::array<std::uint32_t, 4> front_id{};
    for (std::size_t i = 0; i < 4; ++i) {
        front_id[i] = pen.add(vec3(face[i] + inset[i], front), {0, 0, 1}, face[i] + inset[i]);
    }
    pen.quad(front_id[0], front_id[1], front_id[2], front_id[3]);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        const vec2 edge = glm::normalize(face[j] - face[i]);
        const vec3 out(edge.y, -edge.x, 0);
        const auto side = [&](std::size_t k, float z) {
            return pen.add(vec3(face[k], z), out, face[k] + vec2(0, front - z));
        };
        const std::uint32_t a = side(i, front - cut), b = side(j, front - cut);
        pen.quad(front_id[i], front_id[j], b, a);
        pen.quad(a, b, side(j, back), side(i, back));
    }
    for (std::size_t i = 0; i < 4; ++i) { // the small triangles where two chamfers meet
        const std::size_t before = (i + 3) % 4, after = (i + 1) % 4;
        const vec2 e0 = glm::normalize(face[i] - face[before]), e1 = glm::normalize(face[after] - face[i]);
        const std::uint32_t a = pen.add(vec3(face[i], front - cut), {e0.y, -e0.x, 0}, face[i]);
        const std::uint32_t b = pen.add(vec3(face[i], front - cut), {e1.y, -e1.x, 0}, face[i]);
        pen.triangle(front_id[i], a, b);
    }
}

} // namespace atrium::courtyard
