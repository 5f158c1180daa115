// The gallery's timber ceiling, the rafters and the tiles.
#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {
namespace {

constexpr float tile_pitch = 0.24f, tile_row = 0.4f; ///< the roof texture holds 7 x 4 tiles of 0.2286 x 0.4 m
constexpr float texture_column = 1.6f / 7;
constexpr float eaves_y = 9.88f;

/// Local space of a roof: x along the eaves, y away from the slope, z down the slope; z = 0 at the eaves' edge.
mat4 slope_frame(const Side& side)
{
    const float run = 1 / std::sqrt(1 + roof_slope * roof_slope), fall = roof_slope * run;
    return side.frame * frame_of({1, 0, 0}, {0, run, fall}, {0, -fall, run}, {0, eaves_y, eaves_overhang});
}

float slope_length(float run)
{
    return run * std::sqrt(1 + roof_slope * roof_slope);
}

/// One cover tile from z = low (down the slope) to high, arched, a little wider below; its mouth is closed with mortar.
void draw_cover(Pen& pen, float x, float low, float high, float radius_low, float radius_high, float lift, int segments,
                vec2 cell, bool mouth)
{
    pen.set_uv_offset(cell);
    const float rows = (low - high) / tile_row;
    std::uint32_t rim[2] = {0, 0};
    for (int j = 0; j < 2; ++j) {
        const float r = j == 0 ? radius_low : radius_high, z = j == 0 ? low : high;
        for (int i = 0; i <= segments; ++i) {
            const float a = pi * (static_cast<float>(i) / static_cast<float>(segments) - 0.5f);
            const vec2 way(std::sin(a), std::cos(a));
            const float y = r * way.y + (j == 0 ? lift : 0.0f);
            const vec2 uv(texture_column * (static_cast<float>(i) / static_cast<float>(segments)),
                          j == 0 ? 0.0f : tile_row * rows);
            const std::uint32_t id = pen.add({x + r * way.x, y, z}, {way.x, way.y, 0}, uv);
            if (i == 0) {
                rim[j] = id;
            }
        }
    }
    pen.strip(rim[0], rim[1], static_cast<std::uint32_t>(segments + 1));
    if (!mouth) {
        return;
    }
    const std::uint32_t hub = pen.add({x, lift, low - 0.012f}, {0, 0, 1}, {0.5f * texture_column, 0.03f});
    std::uint32_t before = 0;
    for (int i = 0; i <= segments; ++i) {
        const float a = pi * (static_cast<float>(i) / static_cast<float>(segments) - 0.5f);
        const vec2 way(std::sin(a), std::cos(a));
        const std::uint32_t id = pen.add({x + radius_low * way.x, radius_low * way.y + lift, low}, {0, 0, 1},
                                         vec2(0.5f * texture_column, 0.03f) + 0.1f * way);
        if (i > 0) {
            pen.triangle(hub, before, id);
        }
        before = id;
    }
}

/// Channel tiles between two columns of covers: one hollow strip over the whole slope.
void draw_channel(Pen& pen, float x, float low, float high, int segments, vec2 cell)
{
    pen.set_uv_offset(cell);
    const float radius = 0.5f * tile_pitch;
    std::uint32_t rows[2] = {0, 0};
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i <= segments; ++i) {
            const float a = pi * (static_cast<float>(i) / static_cast<float>(segments) - 0.5f);
            const std::uint32_t id = pen.add(
                {x + radius * std::sin(a), 0.6f * radius * (1 - std::cos(a)), j == 0 ? low : high},
                {-std::sin(a), std::cos(a) + 0.4f, 0},
                {texture_column * static_cast<float>(i) / static_cast<float>(segments), j == 0 ? 0.0f : low - high});
            if (i == 0) {
                rows[j] = id;
            }
        }
    }
    pen.strip(rows[0], rows[1], static_cast<std::uint32_t>(segments + 1));
}

void build_tiles(Court& court, const Side& side)
{
    const Fineness& f = court.fine;
    Random random(court.seed, "tiles_" + side.name);
    Pen pen = court.pen("roof_" + side.name, "roof_tile", slope_frame(side));
    const float run = eaves_overhang + aisle_depth + outer_thickness - 0.05f;
    const float widest = side.half - eaves_overhang + run;
    if (f.tile_rows == 0) { // one textured plane, cut along the valleys
        const float low = slope_length(0.0f), high = slope_length(run), half = side.half - eaves_overhang;
        const vec3 up(0, 1, 0);
        pen.quad(pen.add({-half, 0, -low}, up, {-half, 0}), pen.add({half, 0, -low}, up, {half, 0}),
                 pen.add({widest, 0, -high}, up, {widest, high}), pen.add({-widest, 0, -high}, up, {-widest, high}));
        return;
    }
    const int columns = static_cast<int>(2 * widest / tile_pitch);
    for (int c = 0; c < columns; ++c) {
        const float x = (static_cast<float>(c) + 0.5f - 0.5f * static_cast<float>(columns)) * tile_pitch;
        const float valley = std::max(0.0f, std::abs(x) - (side.half - eaves_overhang));
        const float low = -slope_length(valley) + 0.012f, high = -slope_length(run);
        if (low - high < 0.15f) {
            continue;
        }
        const auto cell = [&] {
            return vec2(texture_column * static_cast<float>(random.below(7)),
                        tile_row * static_cast<float>(random.below(4)));
        };
        draw_channel(pen, x + 0.5f * tile_pitch, low, high, f.tile, cell());
        float z = low + random.around(0, 0.012f);
        for (int r = 0; r < f.tile_rows && z - tile_row > high; ++r) {
            const float shift = random.around(0, 0.006f), lift = 0.035f + random.around(0, 0.006f);
            draw_cover(pen, x + shift, z, z - tile_row - 0.05f, 0.092f, 0.078f, lift, f.tile, cell(), true);
            z -= tile_row;
        }
        if (z - high > 0.05f) {
            draw_cover(pen, x, z, high, 0.088f, 0.08f, 0.03f, f.tile, cell(), true);
        }
    }
}

void build_rafters(Court& court, const Side& side)
{
    const mat4 slope = slope_frame(side);
    const float reach = side.half - eaves_overhang;
    Pen board = court.pen("eaves_" + side.name, "wood_beam", slope);
    // Boards that carry the tiles, seen from below, and a fascia at their edge.
    draw_plane(board, {reach - 0.005f, -0.012f, -0.01f}, {-2 * reach + 0.01f, 0, 0}, {0, 0, -0.68f}, 12, 1);
    draw_box(board, {{-reach - 0.004f, -0.05f, -0.03f}, {reach + 0.004f, 0.02f, 0.004f}, 0.006f, 0, true});
    // The wall plate closes the gap between the cornice and the boards.
    Pen plate = court.pen("eaves_" + side.name, "wood_beam", side.frame);
    const float inner = side.half - 0.1f;
    draw_box(plate, {{-inner, eaves_top - 0.06f, -0.05f}, {inner, eaves_y + 0.24f, 0.1f}, 0.01f, 0, true});
    const int count = static_cast<int>(2 * reach / (court.fine.small_things ? 0.6f : 2.6f));
    Random random(court.seed, "rafters_" + side.name);
    for (int i = 0; i <= count; ++i) {
        const float x = -reach + 0.12f + (2 * reach - 0.24f) * static_cast<float>(i) / static_cast<float>(count);
        board.set_uv_offset({random.unit(), random.unit()});
        draw_box(board,
                 {{x - 0.045f, -0.135f, -0.75f}, {x + 0.045f, -0.008f, -0.075f}, 0.012f, face_top | face_back, true});
    }
}

} // namespace

void build_gallery_ceiling(Court& court)
{
    for (const Side& side : sides()) {
        const bool is_long = side.bays == long_bays;
        const float reach = is_long ? side.half + aisle_depth : side.half + upper_wall_half - 0.02f;
        const float near = -upper_wall_half + 0.02f;
        Pen planks = court.pen("ceiling_" + side.name, "wood_beam", side.frame);
        draw_plane(planks, {-reach, gallery_ceiling, -aisle_depth}, {2 * reach, 0, 0}, {0, 0, aisle_depth + near}, 12,
                   2);
        Pen beam = court.pen("beams_" + side.name, "wood_beam", side.frame);
        Random random(court.seed, "beams_" + side.name);
        const int count = static_cast<int>(2 * reach / (court.fine.small_things ? 0.65f : 1.3f));
        for (int i = 0; i < count; ++i) {
            const float x = -reach + 2 * reach * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
            beam.set_uv_offset({random.unit() * 1.6f, random.unit() * 1.6f});
            draw_box(beam, {{x - 0.055f, gallery_ceiling - 0.17f, -aisle_depth - 0.02f},
                            {x + 0.055f, gallery_ceiling + 0.01f, near + 0.01f},
                            0.014f,
                            face_top | face_back | face_front,
                            true});
        }
        if (!is_long) {
            continue;
        }
        for (const float sign : {-1.0f, 1.0f}) { // girders that carry the corner's beams
            const float from = sign * (side.half + 0.1f), to = sign * (side.half + aisle_depth + 0.02f);
            draw_box(beam, {{std::min(from, to), gallery_ceiling - 0.36f, -0.1f},
                            {std::max(from, to), gallery_ceiling - 0.15f, 0.1f},
                            0.018f,
                            0,
                            true});
        }
    }
}

void build_roof(Court& court)
{
    for (const Side& side : sides()) {
        build_rafters(court, side);
        build_tiles(court, side);
    }
}

} // namespace atrium::courtyard
