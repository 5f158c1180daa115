#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace atrium::courtyard {
namespace {

/// Radius of a shaft with entasis: straight for the lower third, then curving in to 5/6 at the neck.
float shaft_radius(float foot, float share)
{
    const float t = glm::clamp((share - 1.0f / 3) / (2.0f / 3), 0.0f, 1.0f);
    return foot * (1 - t * t * (1.0f / 6));
}

struct Order {
    float radius, height;
    float base, capital; ///< their heights
    float plinth_half, abacus_half;
    int segments, rings;
    int leaf_pieces; ///< 0: no leaves
};

void draw_base(Pen& stone, const Order& o, const Cut& cut)
{
    const float plinth = 0.42f * o.base;
    draw_box(stone,
             {{-o.plinth_half, -0.02f, -o.plinth_half}, {o.plinth_half, plinth, o.plinth_half}, 0.012f, face_bottom});
    const float unit = (o.base - plinth) / 10; // Attic base: torus, fillets and hollow, torus, apophyge
    ProfilePath p({o.plinth_half - 2.2f * unit, plinth - 0.01f}, cut);
    p.by(0, 0.01f).torus(3.8f * unit).by(-0.4f * unit, 0).by(0, 0.6f * unit).scotia(2.2f * unit, 0.9f * unit);
    p.by(0, 0.5f * unit).torus(2.1f * unit).to(o.radius * 1.06f, p.end().y).by(0, 0.3f * unit);
    p.ovolo(-0.06f * o.radius, o.base - p.end().y);
    draw_lathe(stone, p.finish(0.004f), {.segments = o.segments});
}

void draw_shaft(Pen& pen, const Order& o, float from, float to)
{
    ProfilePath p({shaft_radius(o.radius, 0), from}, Cut{1});
    for (int i = 1; i <= o.rings; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(o.rings);
        p.to(shaft_radius(o.radius, share), from + share * (to - from));
    }
    draw_lathe(pen, p.finish(0), {.segments = o.segments, .u_repeats = 1, .unit_v = true});
}

/// A leaf of the capital: up along the bell, then over in a curl.
void draw_leaf(Pen& stone, float angle, float foot_radius, float y, float rise, float width, int pieces)
{
    Pen leaf = stone.moved(turned(angle));
    const float curl = 0.32f * rise, turn = 2.5f; // radius and angle of the curl
    const float straight = rise, bent = curl * turn;
    Sheet sheet{.pieces_s = pieces, .pieces_t = 2 * pieces, .thickness = 0.012f, .rims = pieces > 2, .at = {}};
    sheet.at = [=](float s, float t) {
        const float x = 2 * s - 1, way = t * (straight + bent);
        float radius = foot_radius, height = y;
        if (way < straight) {
            const float k = way / straight;
            radius += 0.16f * rise * k * k;
            height += way;
        } else {
            const float a = (way - straight) / curl;
            radius += 0.16f * rise + curl * (1 - std::cos(a));
            height += straight + curl * std::sin(a);
        }
        const float half = 0.5f * width * (1 - 0.55f * t * t * t) * (0.85f + 0.15f * std::cos(18 * t));
        return SheetPoint{{x * half, height, radius - 0.1f * width * x * x}, {x * half, way}};
    };
    draw_sheet(leaf, sheet);
}

void draw_capital(Pen& stone, const Order& o, float top, const Cut& cut)
{
    const float abacus = 0.24f * o.capital, neck = shaft_radius(o.radius, 1);
    const float foot = top - o.capital, bell_top = top - abacus;
    ProfilePath p({neck, foot - 0.02f}, cut);
    p.by(0, 0.02f).torus(0.11f * o.capital).by(0, 0.03f * o.capital);
    const float flare = 0.86f * o.abacus_half - neck;
    p.cavetto(flare, bell_top - 0.1f * o.capital - p.end().y)
        .ovolo(0.02f, 0.05f * o.capital)
        .to(p.end().x, bell_top + 0.01f);
    draw_lathe(stone, p.finish(0.004f), {.segments = o.segments});
    ProfilePath a({-0.6f * o.abacus_half, bell_top}, cut);
    a.to(-0.03f, bell_top).cavetto(0.03f, 0.45f * abacus).by(0.012f, 0).to(0.012f, top).by(-0.1f, 0);
    draw_rect_sweep(stone, a.finish(0.006f), {.half_x = o.abacus_half - 0.012f, .half_z = o.abacus_half - 0.012f});
    const int leaf_pieces = o.leaf_pieces;
    if (leaf_pieces == 0) {
        return;
    }
    for (int i = 0; i < 8; ++i) {
        const bool corner = i % 2 == 1;
        draw_leaf(stone, 0.25f * pi * static_cast<float>(i), neck + 0.012f, foot + 0.1f * o.capital,
                  (corner ? 0.5f : 0.3f) * o.capital, corner ? 0.13f : 0.15f, leaf_pieces);
    }
}

void draw_column(Court& court, const std::string& group, const mat4& place, const Order& o, Random& random)
{
    Pen stone = court.pen(group, "limestone_trim", place);
    stone.set_uv_offset({random.unit(), random.unit()});
    draw_base(stone, o, court.fine.cut);
    draw_capital(stone, o, o.height, court.fine.cut);
    Pen shaft = court.pen(group, "column_stone", place * turned(2 * pi * random.unit()));
    draw_shaft(shaft, o, o.base, o.height - o.capital);
}

/// Square pier of the corners, moulded like the columns beside it.
void draw_pier(Court& court, const std::string& group, const mat4& place, float half, float height, float base,
               float capital)
{
    Pen stone = court.pen(group, "limestone_trim", place);
    ProfilePath p({0.06f, -0.02f}, court.fine.cut);
    p.to(0.06f, 0.45f * base).by(-0.015f, 0).torus(0.22f * base).by(-0.01f, 0).by(0, 0.04f * base);
    p.ovolo(-p.end().x, base - p.end().y).to(0, height - capital);
    p.torus(0.1f * capital).by(0, 0.32f * capital).ovolo(0.02f, 0.12f * capital).by(0, 0.06f * capital);
    p.cavetto(0.03f, 0.18f * capital).by(0.012f, 0).to(0.062f, height).by(-0.09f, 0);
    draw_rect_sweep(stone, p.finish(0.008f), {.half_x = half, .half_z = half, .chamfer = 0.02f});
}

/// Pedestal of the upper columns, as high as the balustrade.
void draw_pedestal(Court& court, const std::string& group, const mat4& place, float half)
{
    Pen stone = court.pen(group, "limestone_trim", place);
    ProfilePath p({0.035f, -0.03f}, court.fine.cut);
    p.to(0.035f, 0.11f).cavetto(-0.035f, 0.03f).to(0, rail_height - 0.15f);
    p.cavetto(0.03f, 0.04f).by(0.012f, 0).to(0.042f, rail_height).by(-half, 0);
    draw_rect_sweep(stone, p.finish(0.007f), {.half_x = half, .half_z = half, .chamfer = 0.012f});
}

} // namespace

void build_columns(Court& court)
{
    const Fineness& f = court.fine;
    const Order lower{0.5f * column_diameter, column_height, 0.24f, 0.46f, 0.3f, 0.33f, f.column,
                      f.shaft_rings,          f.leaf_pieces};
    const Order upper{0.5f * upper_diameter, upper_height,  0.15f, 0.24f, 0.185f, 0.2f,
                      f.column_small,        f.shaft_rings, 0};
    for (const Side& side : sides()) {
        for (int i = 0; i < side.bays; ++i) { // i = 0 is this side's left corner: each corner is drawn once
            Random random(court.seed, side.name, static_cast<std::uint32_t>(i));
            const mat4 foot = side.frame * moved_to({side.axis(i), aisle_floor, 0});
            const mat4 gallery = side.frame * moved_to({side.axis(i), gallery_floor, 0});
            const mat4 above = side.frame * moved_to({side.axis(i), gallery_floor + rail_height, 0});
            const std::string number = fmt::format("{}_{:02}", side.name, i);
            if (i == 0) {
                draw_pier(court, "pier_" + number, foot, 0.29f, column_height, 0.24f, 0.4f);
                draw_pedestal(court, "pedestal_" + number, gallery, 0.23f);
                draw_pier(court, "upper_pier_" + number, above, 0.175f, upper_height, 0.14f, 0.24f);
            } else {
                draw_column(court, "column_" + number, foot, lower, random);
                draw_pedestal(court, "pedestal_" + number, gallery, 0.2f);
                draw_column(court, "upper_column_" + number, above, upper, random);
            }
        }
    }
}

} // namespace atrium::courtyard
