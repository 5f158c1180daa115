#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/reliefs.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <cmath>

namespace atrium::courtyard {
namespace {

constexpr int basin_sides = 8;
constexpr float basin_radius = 1.3f, basin_height = 0.62f, water_level = 0.5f; // radius to the octagon's corners

void draw_basin(Court& court, const mat4& place)
{
    const Cut& cut = court.fine.cut;
    Pen stone = court.pen("fountain_basin", "limestone_trim", place);
    const Lathe octagon{.segments = basin_sides, .u_repeats = 7, .faceted = true};
    ProfilePath step({1.78f, -0.03f}, cut);
    step.to(1.78f, 0.09f).torus(0.035f).to(1.76f, 0.13f).to(basin_radius - 0.1f, 0.135f);
    draw_lathe(stone, step.finish(0.012f), octagon);
    ProfilePath wall({basin_radius + 0.09f, 0.12f}, cut);
    wall.to(basin_radius + 0.09f, 0.19f).torus(0.045f).ovolo(-0.07f, 0.05f).to(basin_radius, 0.3f);
    wall.to(basin_radius, 0.47f).cavetto(0.06f, 0.06f).by(0.015f, 0).torus(0.075f).by(-0.01f, 0).by(0, 0.012f);
    wall.to(basin_radius - 0.12f, basin_height)
        .to(basin_radius - 0.15f, basin_height - 0.03f)
        .to(basin_radius - 0.15f, 0.2f);
    draw_lathe(stone, wall.finish(0.01f), octagon);
    Pen water = court.pen("fountain_water", "water", place);
    draw_disc(water, water_level, 0.05f, basin_radius - 0.1f, basin_sides * 4);
}

/// A bowl on its stem; y from 0.
void draw_bowl(Pen& stone, float stem_foot, float rim_y, float radius, float stem, const Court& court)
{
    ProfilePath p({stem * 1.9f, stem_foot}, court.fine.cut);
    p.by(0, 0.05f).torus(0.06f).by(-0.02f, 0).ovolo(-0.75f * stem, 0.09f);
    const float height = rim_y - p.end().y;
    p.ovolo(0.35f * stem, 0.18f * height).cavetto(-0.5f * stem, 0.2f * height).by(0, 0.06f * height).torus(0.035f);
    p.cavetto(0.3f * stem, 0.04f);
    const float under = p.end().y, left = rim_y - under; // the bowl's underside swells out to the rim
    p.to(0.3f * radius, under + 0.1f * left)
        .to(0.55f * radius, under + 0.25f * left)
        .to(0.78f * radius, under + 0.48f * left);
    p.to(0.92f * radius, under + 0.74f * left).to(0.97f * radius, rim_y - 0.045f).by(0.012f, 0).torus(0.045f);
    p.to(0.94f * radius, rim_y + 0.003f).to(0.9f * radius, rim_y - 0.03f).to(0.6f * radius, rim_y - 0.11f);
    p.to(0.06f, rim_y - 0.14f);
    draw_lathe(stone, p.finish(0.006f), {.segments = court.fine.lathe});
}

void draw_finial(Court& court, const mat4& place)
{
    Pen bronze = court.pen("fountain_finial", "bronze", place);
    ProfilePath p({0.06f, 1.76f}, court.fine.cut);
    p.torus(0.04f).by(-0.015f, 0).cavetto(-0.02f, 0.04f).by(0, 0.02f);
    p.to(0.055f, 1.9f)
        .to(0.072f, 1.94f)
        .to(0.078f, 1.98f)
        .to(0.07f, 2.03f)
        .to(0.05f, 2.08f)
        .to(0.022f, 2.12f)
        .to(0.002f, 2.14f);
    draw_lathe(bronze, p.finish(0.003f), {.segments = 2 * (court.fine.lathe / 3)});
}

} // namespace

void build_fountain(Court& court)
{
    const mat4 place = turned(pi / basin_sides);
    draw_basin(court, place);
    Pen bowl = court.pen("fountain_bowl", "limestone_trim", place);
    draw_bowl(bowl, 0.2f, 1.24f, 0.68f, 0.11f, court);
    Pen small = court.pen("fountain_small_bowl", "limestone_trim", place);
    draw_bowl(small, 1.08f, 1.72f, 0.34f, 0.065f, court);
    Pen water = court.pen("fountain_water", "water", place);
    draw_disc(water, 1.205f, 0.05f, 0.63f, court.fine.lathe);
    draw_disc(water, 1.69f, 0.03f, 0.31f, court.fine.lathe);
    draw_finial(court, place);
    for (int i = 0; i < basin_sides; ++i) { // a lion on each panel of the basin
        const float apothem = basin_radius * std::cos(pi / basin_sides);
        const mat4 panel =
            place * turned(2 * pi * (static_cast<float>(i) + 0.5f) / basin_sides) * moved_to({0, 0.385f, apothem});
        draw_medallion(court, "fountain_lions", panel, 0.085f);
    }
}

} // namespace atrium::courtyard
