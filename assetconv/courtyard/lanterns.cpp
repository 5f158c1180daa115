#include "assetconv/courtyard/lanterns.hpp"

#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace atrium::courtyard {
namespace {

constexpr float hook_y = springing + vault_rise, glass_y = springing - 0.55f;

/// Six-sided lantern; the glass's middle at the origin.
void draw_lantern(Court& court, const std::string& group, const mat4& place)
{
    const Cut& cut = court.fine.cut;
    const Lathe hexagon{.segments = 6, .u_repeats = 2, .faceted = true};
    Pen glass = court.pen(group, "lantern_glass", place);
    draw_lathe(glass, ProfilePath({0.095f, -0.17f}, Cut{1}).to(0.13f, 0.16f).finish(0), hexagon);
    Pen iron = court.pen(group, "iron", place);
    ProfilePath foot({0.01f, -0.27f}, cut);
    foot.ovolo(0.03f, 0.03f).by(0.03f, 0.02f).cavetto(0.05f, 0.03f).by(0, 0.03f).to(0.09f, -0.155f);
    draw_lathe(iron, foot.finish(0.003f), hexagon);
    ProfilePath cap({0.12f, 0.15f}, cut);
    cap.to(0.175f, 0.145f)
        .to(0.175f, 0.17f)
        .to(0.1f, 0.25f)
        .to(0.055f, 0.27f)
        .by(0, 0.04f)
        .to(0.07f, 0.315f)
        .to(0.015f, 0.36f);
    draw_lathe(iron, cap.finish(0.004f), hexagon);
    for (int i = 0; i < 6; ++i) {
        const float a = pi / 3 * static_cast<float>(i);
        const vec3 way(std::sin(a), 0, std::cos(a));
        if (court.fine.small_things)
            draw_rod(iron, 0.099f * way + vec3(0, -0.175f, 0), 0.134f * way + vec3(0, 0.165f, 0), 0.009f, 0.009f, 4);
    }
    if (!court.fine.small_things) {
        return;
    }
    draw_ball(iron, {0, -0.285f, 0}, 0.022f, 6);
    draw_ring(iron, {0, 0.395f, 0}, 0.04f, 0.008f, 8, 3);
}

/// Two crossed cards with the picture of a chain, masked.
void draw_chain(Court& court, const std::string& group, const mat4& place, float from, float to)
{
    Pen chain = court.pen(group, "chain", place);
    constexpr float half = 0.03f, picture = 0.24f; // the picture is four links high
    for (int k = 0; k < 2; ++k) {
        const vec3 across = k == 0 ? vec3(half, 0, 0) : vec3(0, 0, half),
                   normal = k == 0 ? vec3(0, 0, 1) : vec3(-1, 0, 0);
        const float top = (to - from) / picture, shift = 0.125f * static_cast<float>(k);
        const vec3 low(0, from, 0), high(0, to, 0);
        chain.quad(chain.add(low - across, normal, {0, shift}), chain.add(low + across, normal, {1, shift}),
                   chain.add(high + across, normal, {1, top + shift}),
                   chain.add(high - across, normal, {0, top + shift}));
    }
}

} // namespace

const std::vector<Lantern>& lanterns()
{
    static const std::vector<Lantern> all{{north, 1, true},  {north, 3, false}, {north, 5, true}, {south, 2, true},
                                          {south, 4, false}, {south, 6, false}, {east, 1, true},  {west, 1, false}};
    return all;
}

vec3 lantern_position(const Lantern& lantern)
{
    const Side& side = sides()[static_cast<std::size_t>(lantern.side)];
    const float across = -0.5f * (wall_half + aisle_depth);
    return vec3(side.frame * vec4(side.bay_centre(lantern.bay), glass_y, across, 1));
}

void build_lanterns(Court& court)
{
    for (const Lantern& l : lanterns()) {
        const Side& side = sides()[static_cast<std::size_t>(l.side)];
        const std::string group = fmt::format("lantern_{}_{:02}", side.name, l.bay);
        const mat4 place = moved_to(lantern_position(l)) * mat4(mat3(side.frame));
        draw_lantern(court, group, place);
        draw_chain(court, group, place, 0.42f, hook_y - glass_y - 0.01f);
        Pen iron = court.pen(group, "iron", place);
        Pen boss = iron.moved(moved_to({0, hook_y - glass_y, 0}));
        ProfilePath p({0.02f, -0.05f}, court.fine.cut);
        p.by(0.01f, 0).ovolo(0.06f, 0.03f).to(0.1f, -0.01f).to(0.1f, 0.03f);
        draw_lathe(boss, p.finish(0.003f), {.segments = 6});
    }
}

} // namespace atrium::courtyard
