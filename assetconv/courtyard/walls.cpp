// The outer walls: what closes the aisles, and the outside of the house.
#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/openings.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

namespace atrium::courtyard {

const std::vector<Opening>& openings()
{
    static const std::vector<Opening> all{
        {north, 1, false, 0.62f, 2.5f, false}, {north, 3, false, 0.62f, 2.5f, false},
        {north, 5, false, 0.62f, 2.5f, false}, {south, 0, false, 0.62f, 2.5f, false},
        {south, 2, false, 0.62f, 2.5f, false}, {south, 6, false, 0.62f, 2.5f, false},
        {west, 1, false, 0.8f, 2.8f, false},   {north, 0, true, 0.52f, 2.2f, true},
        {north, 2, true, 0.52f, 2.2f, true},   {north, 4, true, 0.52f, 2.2f, true},
        {north, 6, true, 0.52f, 2.2f, true},   {south, 1, true, 0.52f, 2.2f, true},
        {south, 3, true, 0.52f, 2.2f, true},   {south, 5, true, 0.52f, 2.2f, true},
        {east, 1, true, 0.6f, 2.3f, true},     {west, 1, true, 0.6f, 2.3f, true},
    };
    return all;
}

std::optional<Opening> opening_of(int side, int bay_index, bool upper)
{
    for (const Opening& o : openings()) {
        if (o.side == side && o.bay == bay_index && o.upper == upper) {
            return o;
        }
    }
    return std::nullopt;
}

namespace {

struct Storey {
    const char* material;
    float low, high;
    float v_at_zero; ///< texture coordinate v of y = 0, metres
};
const Storey storeys[2] = {
    {"plaster", aisle_floor - 0.02f, aisle_floor + plaster_tile - 0.05f, -aisle_floor},
    {"plaster_ochre", gallery_floor - 0.05f, gallery_ceiling + 0.05f, plaster_tile - gallery_ceiling - 0.1f},
};

/// A piece of wall in the plane z = -aisle_depth.
void draw_piece(Pen& pen, float x0, float x1, float y0, float y1, const Storey& s, float u_origin)
{
    if (x1 - x0 < 1e-3f || y1 - y0 < 1e-3f) {
        return;
    }
    draw_plane(pen, {x0, y0, -aisle_depth}, {x1 - x0, 0, 0}, {0, y1 - y0, 0}, 1, 2, {u_origin + x0, y0 + s.v_at_zero});
}

void build_skirting(Court& court, bool upper)
{
    const float floor = upper ? gallery_floor : aisle_floor;
    ProfilePath p({0.03f, floor - 0.03f}, court.fine.cut);
    p.to(0.03f, floor + (upper ? 0.14f : 0.2f)).cavetto(-0.02f, 0.03f).to(-0.03f, p.end().y);
    const Profile profile = p.finish(0.006f);
    for (int k = 0; k < 4; ++k) {
        const Side& side = sides()[static_cast<std::size_t>(k)];
        Pen stone = court.pen((upper ? "gallery_skirting_" : "skirting_") + side.name, "limestone_trim",
                              side.frame * moved_to({0, 0, -aisle_depth}));
        // The short sides end at the faces of the long ones.
        const float end = side.half + aisle_depth - (side.bays == long_bays ? 0.0f : 0.025f);
        float from = -end;
        for (int i = 0; i < side.bays; ++i) {
            const auto hole = opening_of(k, i, upper);
            if (!hole) {
                continue;
            }
            draw_straight_sweep(stone, profile, from, side.bay_centre(i) - hole->half_width - 0.1f, 2);
            from = side.bay_centre(i) + hole->half_width + 0.1f;
        }
        draw_straight_sweep(stone, profile, from, end, 2);
    }
}

void build_outside(Court& court)
{
    constexpr float top = 11.45f;
    const float x = half_length + aisle_depth + outer_thickness, z = half_width + aisle_depth + outer_thickness;
    Pen wall = court.pen("outside", "plaster_ochre");
    draw_rect_sweep(wall, ProfilePath({0, -0.1f}, Cut{1}).to(0, top - 0.15f).finish(0), {x, z, false, 0.02f, 4});
    Pen coping = court.pen("coping", "limestone_trim");
    ProfilePath p({-0.02f, top - 0.17f}, court.fine.cut);
    p.to(0.06f, top - 0.17f).to(0.06f, top - 0.06f).to(-0.2f, top).to(-0.42f, top - 0.06f).to(-0.42f, top - 0.4f);
    draw_rect_sweep(coping, p.finish(0.012f), {x, z, false, 0.02f, 4});
}

} // namespace

void build_outer_walls(Court& court)
{
    for (int k = 0; k < 4; ++k) {
        const Side& side = sides()[static_cast<std::size_t>(k)];
        const float u_origin = 3.1f * static_cast<float>(k);
        for (int upper = 0; upper < 2; ++upper) {
            const Storey& s = storeys[upper];
            Pen wall = court.pen(fmt::format("{}_wall_{}", upper != 0 ? "gallery" : "aisle", side.name), s.material,
                                 side.frame);
            draw_piece(wall, -side.half - aisle_depth, -side.half, s.low, s.high, s, u_origin);
            draw_piece(wall, side.half, side.half + aisle_depth, s.low, s.high, s, u_origin);
            for (int i = 0; i < side.bays; ++i) {
                const float x0 = side.axis(i), x1 = side.axis(i + 1), c = side.bay_centre(i);
                const auto hole = opening_of(k, i, upper != 0);
                if (!hole) {
                    draw_piece(wall, x0, x1, s.low, s.high, s, u_origin);
                    continue;
                }
                const float top = (upper != 0 ? gallery_floor : aisle_floor) + hole->height;
                draw_piece(wall, x0, c - hole->half_width, s.low, s.high, s, u_origin);
                draw_piece(wall, c + hole->half_width, x1, s.low, s.high, s, u_origin);
                draw_piece(wall, c - hole->half_width, c + hole->half_width, top, s.high, s, u_origin);
            }
        }
    }
    build_skirting(court, false);
    build_skirting(court, true);
    build_outside(court);
}

} // namespace atrium::courtyard
