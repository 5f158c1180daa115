#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

namespace atrium::courtyard {
namespace {

constexpr float plinth_top = 0.13f, rail_bottom = rail_height - 0.14f;

/// A turned baluster with one belly low down, y from 0 to 1; widths in shares of its height.
Profile baluster_profile(float height, const Cut& cut)
{
    const auto h = [height](float share) { return share * height; };
    ProfilePath p({h(0.095f), h(0.06f)}, cut);
    p.by(0, h(0.07f)).to(h(0.062f), h(0.16f)); // the belly swells, then runs up into the neck
    p.to(h(0.105f), h(0.23f))
        .to(h(0.122f), h(0.32f))
        .to(h(0.108f), h(0.42f))
        .to(h(0.075f), h(0.55f))
        .to(h(0.047f), h(0.76f));
    p.by(h(0.03f), h(0.03f)).by(-h(0.025f), h(0.03f)).to(h(0.085f), h(0.9f)).by(0, h(0.05f));
    return p.finish(0.004f);
}

Profile slab(float half_depth, float low, float high, float lip, const Cut& cut)
{
    ProfilePath p({-half_depth + lip, low}, cut);
    p.to(half_depth - lip, low).to(half_depth, low + lip).to(half_depth, high).to(-half_depth, high);
    p.to(-half_depth, low + lip).to(-half_depth + lip, low);
    return p.finish(0.01f);
}

void draw_balustrade(Court& court, const std::string& group, const mat4& place, float half)
{
    const Fineness& f = court.fine;
    Pen stone = court.pen(group, "limestone_trim", place);
    draw_straight_sweep(stone, slab(0.11f, -0.03f, plinth_top, 0.0f, f.cut), -half, half, 1);
    draw_straight_sweep(stone, slab(0.135f, rail_bottom, rail_height - 0.01f, 0.035f, f.cut), -half, half, 1);
    const float height = rail_bottom - plinth_top;
    const Profile profile = baluster_profile(height, f.cut.coarser());
    const float pitch = 2 * half / static_cast<float>(f.balusters_per_bay);
    for (int i = 0; i < f.balusters_per_bay; ++i) {
        const float x = -half + pitch * (static_cast<float>(i) + 0.5f);
        Pen one = court.pen(group, "limestone_trim", place * moved_to({x, plinth_top, 0}));
        one.set_uv_offset({0.17f * static_cast<float>(i), 0.29f * static_cast<float>(i)});
        draw_lathe(one, profile, {.segments = f.baluster, .u_repeats = 1});
        draw_box(one, {{-0.078f, -0.01f, -0.078f}, {0.078f, 0.065f * height, 0.078f}, 0.006f, face_bottom});
        if (f.cut.curve > 2) {
            draw_box(one, {{-0.072f, 0.945f * height, -0.072f}, {0.072f, height + 0.01f, 0.072f}, 0.006f, face_top});
        }
    }
}

} // namespace

void build_balustrades(Court& court)
{
    for (const Side& side : sides()) {
        for (int i = 0; i < side.bays; ++i) {
            // Between the faces of two pedestals; the corner's pedestals are wider.
            const float left = i == 0 ? 0.22f : 0.19f, right = i + 1 == side.bays ? 0.22f : 0.19f;
            const float middle = side.bay_centre(i) + 0.5f * (left - right);
            draw_balustrade(court, fmt::format("balustrade_{}_{:02}", side.name, i),
                            side.frame * moved_to({middle, gallery_floor, 0}), 0.5f * (bay - left - right));
        }
    }
}

} // namespace atrium::courtyard
