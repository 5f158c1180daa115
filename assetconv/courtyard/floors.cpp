#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <algorithm>

namespace atrium::courtyard {
namespace {

constexpr float border = 0.45f; ///< width of the dark slabs around the court
constexpr float court_half_x = half_length - stylobate_edge - step_tread;
constexpr float court_half_z = half_width - stylobate_edge - step_tread;
constexpr float stylobate_back = 0.4f; ///< the stylobate's stones reach so far behind the column axes

void build_steps(Court& court)
{
    ProfilePath p({step_tread, -0.03f}, court.fine.cut);
    for (int i = 1; i <= 2; ++i) {
        const float edge = i == 1 ? step_tread : 0.0f, y = step_height * static_cast<float>(i);
        p.to(edge, y - 0.045f).torus(0.03f).to(edge, y).to(i == 1 ? 0.0f : -stylobate_edge - stylobate_back, y);
    }
    Pen stone = court.pen("steps", "limestone_trim");
    draw_rect_sweep(stone, p.finish(0.008f),
                    {half_length - stylobate_edge, half_width - stylobate_edge, true, 0, long_bays});
}

void build_court_floor(Court& court)
{
    const float x = court_half_x - border, z = court_half_z - border;
    Pen field = court.pen("court_floor", "floor_court");
    draw_plane(field, {-x, 0, z}, {2 * x, 0, 0}, {0, 0, -2 * z}, 14, 5, {-x, -z});
    // Slabs of the border, each its own stone. The field's edge lies under their bevels.
    Pen slab = court.pen("court_border", "floor_border");
    Random random(court.seed, "border");
    const auto lay = [&](vec3 low, vec3 high) {
        slab.set_uv_offset({random.unit() * 1.6f, random.unit() * 1.6f});
        const float settled = random.between(-0.003f, 0.002f);
        draw_box(slab,
                 {low + vec3(0.003f, -0.05f, 0.003f), high + vec3(-0.003f, settled, -0.003f), 0.009f, face_bottom});
    };
    const auto row = [&](float from, float to, const auto& place) {
        const int count = std::max(1, static_cast<int>((to - from) / (court.fine.small_things ? 0.8f : 2.4f) + 0.5f));
        for (int i = 0; i < count; ++i) {
            const float step = (to - from) / static_cast<float>(count), a = from + step * static_cast<float>(i);
            place(a, a + step);
        }
    };
    for (const float sign : {-1.0f, 1.0f}) {
        const float z0 = std::min(sign * z, sign * (court_half_z + 0.01f)),
                    z1 = std::max(sign * z, sign * (court_half_z + 0.01f));
        row(-court_half_x - 0.01f, court_half_x + 0.01f, [&](float a, float b) { lay({a, 0, z0}, {b, 0, z1}); });
        const float x0 = std::min(sign * x, sign * (court_half_x + 0.01f)),
                    x1 = std::max(sign * x, sign * (court_half_x + 0.01f));
        row(-z, z, [&](float a, float b) { lay({x0, 0, a}, {x1, 0, b}); });
    }
}

/// A floor around the court, from `edge` behind the column axes to the outer wall, facing up.
void draw_ring_floor(Pen& pen, float edge, float y, int per_bay)
{
    const float x = half_length + edge, z = half_width + edge;
    const float outer_x = half_length + aisle_depth, outer_z = half_width + aisle_depth;
    for (const float sign : {-1.0f, 1.0f}) {
        const float near = sign < 0 ? -z : outer_z, west = sign < 0 ? -outer_x : x;
        draw_plane(pen, {-outer_x, y, near}, {2 * outer_x, 0, 0}, {0, 0, -(outer_z - z)}, 9 * per_bay, per_bay,
                   {-outer_x, -near});
        draw_plane(pen, {west, y, z}, {outer_x - x, 0, 0}, {0, 0, -2 * z}, per_bay, 3 * per_bay, {west, -z});
    }
}

} // namespace

void build_floors(Court& court)
{
    build_steps(court);
    build_court_floor(court);
    Pen aisle = court.pen("aisle_floor", "floor_aisle");
    draw_ring_floor(aisle, stylobate_back, aisle_floor, court.fine.small_things ? 2 : 1);
    Pen gallery = court.pen("gallery_floor", "floor_aisle");
    draw_ring_floor(gallery, 0.0f, gallery_floor + 0.005f, court.fine.small_things ? 2 : 1);
}

} // namespace atrium::courtyard
