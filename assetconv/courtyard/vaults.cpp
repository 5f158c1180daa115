#include "assetconv/courtyard/arch.hpp"
#include "assetconv/courtyard/court.hpp"

#include <fmt/format.h>

#include <cmath>

namespace atrium::courtyard {
namespace {

constexpr float rib_half = 0.15f, rib_drop = 0.07f;

/// Groin vault over a rectangle of half sizes a (x) and c (z) about the origin, y from the springing: two barrels of
/// the same rise that cross; each of its four webs is a ruled surface from the diagonal to a wall.
void draw_groin_vault(Pen& pen, float a, float c, float rise, int segments)
{
    for (int web = 0; web < 4; ++web) {
        const bool along_x = web % 2 == 0; // the barrel's axis
        const float sign = web < 2 ? 1.0f : -1.0f;
        const float length = along_x ? a : c, half_span = along_x ? c : a;
        std::uint32_t previous = 0;
        for (int i = 0; i <= segments; ++i) {
            const float angle = pi * (static_cast<float>(i) / static_cast<float>(segments) - 0.5f);
            const float across = std::sin(angle), up = std::cos(angle);
            // Normal of the ellipse (half_span sin, rise cos), pointing into the room.
            const vec2 n = -glm::normalize(vec2(across / half_span, up / rise));
            std::uint32_t row = 0;
            for (int j = 0; j < 2; ++j) {
                const float way = sign * length * (j == 0 ? std::abs(across) : 1.0f);
                const vec3 at =
                    along_x ? vec3(way, rise * up, half_span * across) : vec3(half_span * across, rise * up, way);
                const vec3 normal = along_x ? vec3(0, n.y, n.x) : vec3(n.x, n.y, 0);
                const std::uint32_t id = pen.add(at, normal, {way, angle * half_span});
                if (j == 0) {
                    row = id;
                }
            }
            if (i > 0) {
                pen.strip(previous, row, 2);
            }
            previous = row;
        }
    }
}

/// Transverse arch across the aisle: x is the aisle's length, z across it about the origin.
void draw_rib(Pen& pen, float half_span, float rise, int segments, const Cut& cut)
{
    ProfilePath path({-rib_half, 0.12f}, cut);
    path.to(-rib_half, 0).to(rib_half, 0).to(rib_half, 0.12f);
    const Profile profile = path.finish(0.02f);
    std::uint32_t previous = 0;
    for (int i = 0; i <= segments; ++i) {
        const float angle = pi * (static_cast<float>(i) / static_cast<float>(segments) - 0.5f);
        const vec2 out = glm::normalize(vec2(std::sin(angle) / half_span, std::cos(angle) / rise));
        const vec2 foot(half_span * std::sin(angle), rise * std::cos(angle));
        std::uint32_t row = 0;
        for (std::size_t j = 0; j < profile.size(); ++j) {
            const ProfilePoint& p = profile[j];
            const vec2 at = foot + out * p.at.y;
            const vec3 normal(p.normal.x, out.y * p.normal.y, out.x * p.normal.y);
            const std::uint32_t id = pen.add({p.at.x, at.y, at.x}, normal, {angle * half_span, p.length});
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

/// Bracket on the outer wall under a rib: two courses, the upper the larger.
void draw_corbel(Pen& pen, float scale)
{
    float y = -0.46f * scale;
    const float depths[2] = {0.1f, 0.17f}, halves[2] = {0.125f, 0.19f}, heights[2] = {0.34f, 0.12f};
    for (int i = 0; i < 2; ++i) {
        const float top = y + heights[i] * scale + (i == 1 ? 0.01f : 0.0f);
        draw_box(pen,
                 {{-halves[i] * scale, y, -0.03f}, {halves[i] * scale, top, depths[i] * scale}, 0.018f, face_back});
        y = top - 0.005f;
    }
}

} // namespace

void build_vaults(Court& court)
{
    const float near = -wall_half, far = -aisle_depth;
    const float middle = 0.5f * (near + far), half_span = 0.5f * (near - far);
    const int segments = court.fine.arch;
    for (const Side& side : sides()) {
        for (int i = 0; i <= side.bays; ++i) {
            const std::string number = fmt::format("{}_{:02}", side.name, i);
            Pen rib =
                court.pen("rib_" + number, "limestone_trim", side.frame * moved_to({side.axis(i), springing, middle}));
            draw_rib(rib, half_span, vault_rise - rib_drop, segments, court.fine.cut);
            if (court.fine.small_things) {
                Pen corbel =
                    court.pen("rib_" + number, "limestone_trim", side.frame * moved_to({side.axis(i), springing, far}));
                draw_corbel(corbel, 1);
            }
            if (i == side.bays) {
                break;
            }
            Pen vault = court.pen("vault_" + number, "plaster_vault",
                                  side.frame * moved_to({side.bay_centre(i), springing, middle}));
            vault.set_uv_offset({1.1f * static_cast<float>(i), 0});
            draw_groin_vault(vault, 0.5f * bay, half_span, vault_rise, segments);
        }
        // The square corner at this side's left end.
        const float corner_half = 0.5f * aisle_depth;
        Pen corner = court.pen("vault_corner_" + side.name, "plaster_vault",
                               side.frame * moved_to({-side.half - corner_half, springing, -corner_half}));
        draw_groin_vault(corner, corner_half, corner_half, vault_rise, segments);
    }
}

} // namespace atrium::courtyard
