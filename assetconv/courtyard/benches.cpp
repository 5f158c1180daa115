#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/shapes.hpp"

namespace atrium::courtyard {
namespace {

/// A stone bench, 1.7 m long, on two scrolled legs; origin on the ground, front towards z.
void draw_bench(Court& court, const std::string& group, const mat4& place)
{
    Pen stone = court.pen(group, "limestone_trim", place);
    constexpr float half = 0.85f, depth = 0.22f, seat = 0.46f;
    ProfilePath p({-0.03f, seat - 0.085f}, court.fine.cut);
    p.to(0, seat - 0.085f).by(0, 0.02f).cavetto(0.025f, 0.025f).by(0.008f, 0).to(0.033f, seat - 0.008f).to(0.02f, seat);
    p.to(-depth, seat);
    draw_rect_sweep(stone, p.finish(0.008f), {half - 0.033f, depth - 0.033f, false, 0.015f, 2});
    for (const float sign : {-1.0f, 1.0f}) {
        const float x = sign * 0.6f;
        stone.set_uv_offset({0.4f * sign, 0.3f});
        draw_box(stone, {{x - 0.085f, -0.02f, -0.19f}, {x + 0.085f, 0.075f, 0.19f}, 0.014f, face_bottom});
        draw_box(stone, {{x - 0.06f, 0.07f, -0.14f}, {x + 0.06f, seat - 0.1f, 0.14f}, 0.02f, face_bottom | face_top});
        draw_box(stone, {{x - 0.08f, seat - 0.14f, -0.185f}, {x + 0.08f, seat - 0.08f, 0.185f}, 0.016f, face_top});
    }
    draw_box(stone, {{-0.56f, 0.16f, -0.045f}, {0.56f, 0.26f, 0.045f}, 0.014f, face_left | face_right});
}

} // namespace

void build_benches(Court& court)
{
    draw_bench(court, "bench_00", moved_to({4.4f, 0, -2.55f}));
    draw_bench(court, "bench_01", moved_to({-4.4f, 0, 2.55f}) * turned(pi));
    const Side& side = sides()[south];
    draw_bench(court, "bench_02", side.frame * moved_to({side.bay_centre(3), aisle_floor, -aisle_depth + 0.3f}));
}

} // namespace atrium::courtyard
