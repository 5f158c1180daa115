#include "assetconv/courtyard/reliefs.hpp"

#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace atrium::courtyard {

void draw_medallion(Court& court, std::string_view group, const mat4& place, float radius)
{
    const mat4 facing = place * frame_of({1, 0, 0}, {0, 0, 1}, {0, -1, 0}, vec3(0)); // the lathe's axis along z
    const int segments = std::max(8, radius > 0.15f ? (court.fine.lathe * 4) / 5 : court.fine.lathe / 2);
    Pen stone = court.pen(group, "limestone_trim", facing);
    ProfilePath p({1.2f * radius, -0.02f}, court.fine.cut);
    p.by(0, 0.035f).cavetto(-0.05f * radius, 0.012f).by(-0.015f * radius, 0);
    const float lip = 0.17f * radius;
    p.by(0, 0.008f).ovolo(-0.5f * lip, 0.016f).by(-0.5f * lip, 0).to(0.95f * radius, 0.012f);
    if (court.fine.small_things) {
        draw_lathe(stone, p.finish(0.004f), {.segments = segments, .u_repeats = 1});
    }
    Pen lion(court.model.part(group, "relief"), facing, 2.04f * radius);
    lion.set_uv_offset(vec2(1.02f * radius));
    draw_disc(lion, 0.016f, 0.02f * radius, radius, segments);
}

namespace {

void draw_panel(Court& court, const std::string& group, const mat4& place, float half)
{
    Pen stone = court.pen(group, "limestone_trim", place);
    const float band = 0.13f;
    for (const float sign : {-1.0f, 1.0f}) {
        stone.set_uv_offset({0.3f * sign, 0.2f});
        draw_box(stone, {{sign > 0 ? half : -half - band, -half - band, -0.03f},
                         {sign > 0 ? half + band : -half, half + band, 0.075f},
                         0.016f,
                         face_back});
        draw_box(stone, {{-half - 0.01f, sign > 0 ? half : -half - band, -0.03f},
                         {half + 0.01f, sign > 0 ? half + band : -half, 0.07f},
                         0.016f,
                         face_back});
    }
    draw_box(stone, {{-half - band - 0.06f, half + band - 0.005f, -0.03f},
                     {half + band + 0.06f, half + band + 0.07f, 0.13f},
                     0.016f,
                     face_back});
    draw_box(stone, {{-half - band - 0.04f, -half - band - 0.07f, -0.03f},
                     {half + band + 0.04f, -half - band + 0.005f, 0.11f},
                     0.016f,
                     face_back});
    Pen lion(court.model.part(group, "relief"), place, 2 * half);
    draw_plane(lion, {-half - 0.005f, -half - 0.005f, 0.015f}, {2 * half + 0.01f, 0, 0}, {0, 2 * half + 0.01f, 0});
}

} // namespace

void build_reliefs(Court& court)
{
    for (const Side& side : sides()) {
        for (int i = 1; i < side.bays; ++i) {
            draw_medallion(court, "medallions_" + side.name,
                           side.frame * moved_to({side.axis(i), springing + 1.02f, wall_half}), 0.21f);
        }
    }
    const Side& end = sides()[east];
    draw_panel(court, "relief_panel", end.frame * moved_to({end.bay_centre(1), aisle_floor + 1.75f, -aisle_depth}),
               0.72f);
}

} // namespace atrium::courtyard
