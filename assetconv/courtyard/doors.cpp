#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/openings.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace atrium::courtyard {
namespace {

constexpr float frame_width = 0.17f, frame_proud = 0.05f;

/// Stone around the opening; origin at its foot's middle, z = 0 the wall's face.
void draw_frame(Pen& stone, const Opening& o, const Cut& cut)
{
    const float w = o.half_width - 0.03f, outer = o.half_width + frame_width, back = -opening_depth - 0.06f;
    const float bottom = o.upper ? -0.02f : -0.03f;
    draw_box(stone, {{-outer, bottom, back}, {-w, o.height, frame_proud}, 0.014f, face_back});
    stone.set_uv_offset({0.4f, 0.7f});
    draw_box(stone, {{w, bottom, back}, {outer, o.height, frame_proud}, 0.014f, face_back});
    stone.set_uv_offset({0.9f, 0.2f});
    draw_box(stone, {{-outer - 0.008f, o.height - 0.03f, back},
                     {outer + 0.008f, o.height + frame_width, frame_proud + 0.004f},
                     0.014f,
                     face_back});
    // A hood on top: moulding that throws the rain off, though none falls here.
    ProfilePath p({-0.02f, o.height + frame_width - 0.005f}, cut);
    p.to(frame_proud + 0.01f, p.end().y).cyma(0.07f, 0.07f).by(0.01f, 0).by(0, 0.03f).to(-0.02f, p.end().y + 0.02f);
    draw_straight_sweep(stone, p.finish(0.006f), -outer - 0.04f, outer + 0.04f, 1, true);
    draw_box(stone, {{-w - 0.01f, bottom, back}, {w + 0.01f, 0.035f, 0.02f}, 0.012f, face_back});
}

void draw_planks(Court& court, const std::string& group, const mat4& place, const Opening& o, Random& random)
{
    Pen wood = court.pen(group, "wood_door", place);
    const float w = o.half_width - 0.035f, low = 0.045f, high = o.height - 0.035f;
    const int count = !court.fine.small_things ? 1 : o.half_width > 0.7f ? 10 : 8;
    const float step = 2 * w / static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
        const float x = -w + step * static_cast<float>(i);
        const float front = -opening_depth + random.around(0, 0.004f) + (i == count / 2 ? 0.012f : 0.0f);
        wood.set_uv_offset({random.unit() * 1.2f, random.unit() * 1.2f});
        draw_box(
            wood,
            {{x + 0.001f, low, -opening_depth - 0.05f}, {x + step - 0.001f, high, front}, 0.008f, face_back, true});
    }
    if (!court.fine.small_things) {
        return;
    }
    Pen iron = court.pen(group, "iron", place);
    const float z = -opening_depth;
    for (const float y : {0.16f, 0.5f, 0.84f}) {
        for (const float sign : {-1.0f, 1.0f}) {
            const float a = sign * (w - 0.01f), b = sign * 0.12f;
            draw_box(iron, {{std::min(a, b), y * o.height - 0.028f, z - 0.02f},
                            {std::max(a, b), y * o.height + 0.028f, z + 0.016f},
                            0.004f,
                            face_back,
                            true});
            for (int k = 0; k < (court.fine.small_things ? 2 : 0); ++k) {
                const vec3 nail(sign * (0.16f + (w - 0.2f) * static_cast<float>(k)), y * o.height, z + 0.013f);
                draw_box(iron, {nail - vec3(0.014f), nail + vec3(0.014f), 0.006f, face_back});
            }
        }
    }
    Pen bronze = court.pen(group, "bronze", place);
    for (const float sign : {-1.0f, 1.0f}) {
        draw_ball(bronze, {sign * 0.08f, 1.12f, z + 0.02f}, 0.03f, 6);
        draw_ring(bronze, {sign * 0.08f, 1.04f, z + 0.035f}, 0.07f, 0.011f, 9, 4);
    }
}

/// Two louvred leaves.
void draw_shutters(Court& court, const std::string& group, const mat4& place, const Opening& o, Random& random)
{
    Pen wood = court.pen(group, "wood_shutter", place);
    const float w = o.half_width - 0.035f, low = 0.045f, high = o.height - 0.035f, z = -opening_depth;
    if (!court.fine.small_things) {
        draw_box(wood, {{-w, low, z - 0.05f}, {w, high, z}, 0, face_back, true});
        return;
    }
    for (const float sign : {-1.0f, 1.0f}) {
        const float a = sign < 0 ? -w : 0.004f, b = sign < 0 ? -0.004f : w, stile = 0.065f;
        const auto bar = [&](vec3 from, vec3 to) {
            wood.set_uv_offset({random.unit() * 1.2f, random.unit() * 1.2f});
            draw_box(wood, {from, to, 0.006f, face_back, true});
        };
        bar({a, low, z - 0.05f}, {a + stile, high, z});
        bar({b - stile, low, z - 0.05f}, {b, high, z});
        const float rails[3] = {low, 0.45f * (low + high), high - 0.09f};
        for (const float y : rails) {
            bar({a + stile - 0.005f, y, z - 0.05f}, {b - stile + 0.005f, y + 0.09f, z - 0.004f});
        }
        for (int panel = 0; panel < 2; ++panel) {
            const float from = rails[panel] + 0.09f, to = rails[panel + 1];
            const int slats = static_cast<int>((to - from) / 0.085f);
            for (int i = 0; i < slats; ++i) {
                const float y = from + (to - from) * (static_cast<float>(i) + 0.5f) / static_cast<float>(slats);
                const float c = std::cos(0.6f), s = std::sin(0.6f);
                Pen slat = wood.moved(frame_of({1, 0, 0}, {0, c, s}, {0, -s, c}, {0, y, z - 0.03f}));
                slat.set_uv_offset({random.unit() * 1.2f, random.unit() * 1.2f});
                constexpr float reach = 0.05f;
                draw_box(slat, {{a + stile - 0.004f, -reach, -0.006f},
                                {b - stile + 0.004f, reach, 0.006f},
                                0.003f,
                                face_back | face_left | face_right | face_bottom,
                                true});
            }
        }
    }
    Pen dark = court.pen(group, "iron", place);
    draw_plane(dark, {-o.half_width, 0, z - 0.055f}, {2 * o.half_width, 0, 0}, {0, o.height, 0});
}

} // namespace

void build_doors(Court& court)
{
    std::uint32_t index = 0;
    for (const Opening& o : openings()) {
        const Side& side = sides()[static_cast<std::size_t>(o.side)];
        const mat4 place = side.frame * moved_to({side.bay_centre(o.bay),
                                                  o.upper ? gallery_floor + 0.005f : aisle_floor, -aisle_depth});
        const std::string group = fmt::format("{}_{}_{:02}", o.shutters ? "shutters" : "door", side.name, o.bay);
        Random random(court.seed, "door", index++);
        Pen stone = court.pen(group, "limestone_trim", place);
        draw_frame(stone, o, court.fine.cut);
        if (o.shutters) {
            draw_shutters(court, group, place, o, random);
        } else {
            draw_planks(court, group, place, o, random);
        }
    }
}

} // namespace atrium::courtyard
