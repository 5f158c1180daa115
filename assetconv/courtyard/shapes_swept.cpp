#include "assetconv/courtyard/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {
namespace {

float mean_radius(const Profile& profile)
{
    float sum = 0;
    for (const ProfilePoint& p : profile) {
        sum += p.at.x;
    }
    return sum / static_cast<float>(profile.size());
}

} // namespace

void draw_lathe(Pen& pen, const Profile& profile, const Lathe& lathe)
{
    const float around = lathe.sweep * mean_radius(profile);
    const float repeats = static_cast<float>(
        lathe.u_repeats > 0 ? lathe.u_repeats : std::max(1, static_cast<int>(std::lround(around / pen.tile()))));
    const float v_scale = lathe.unit_v ? pen.tile() / profile.back().length : 1.0f;
    const auto count = static_cast<std::uint32_t>(profile.size());
    const float step = lathe.sweep / static_cast<float>(lathe.segments);
    // One column of corners at an angle, with the normal turned to `facing`. -z first, so that u runs to the right.
    const auto column = [&](float angle, float facing) {
        std::uint32_t first = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const ProfilePoint& p = profile[i];
            const vec2 uv(angle / lathe.sweep * repeats * pen.tile(), p.length * v_scale);
            const std::uint32_t id =
                pen.add({p.at.x * std::sin(angle), p.at.y, p.at.x * std::cos(angle)},
                        {p.normal.x * std::sin(facing), p.normal.y, p.normal.x * std::cos(facing)}, uv);
            if (i == 0) {
                first = id;
            }
        }
        return first;
    };
    std::uint32_t previous = column(0, 0);
    for (int j = 0; j < lathe.segments; ++j) {
        const float angle = step * static_cast<float>(j), next_angle = step * static_cast<float>(j + 1);
        if (lathe.faceted) {
            previous = column(angle, angle + 0.5f * step);
        }
        const std::uint32_t next = column(next_angle, lathe.faceted ? angle + 0.5f * step : next_angle);
        pen.strip(previous, next, count);
        previous = next;
    }
}

namespace {

struct Leg {
    vec3 out, along; // unit, of one side of the rectangle
    float distance, half_along;
};

std::uint32_t sweep_column(Pen& pen, const Profile& profile, const RectSweep& sweep, const Leg& leg, float share,
                           float cut)
{
    const float sign = sweep.inwards ? -1.0f : 1.0f;
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const ProfilePoint& p = profile[i];
        const float reach = leg.half_along + sign * p.at.x - cut;
        const vec3 at = leg.out * (leg.distance + sign * p.at.x) + leg.along * (reach * share) + vec3(0, p.at.y, 0);
        const vec3 normal = leg.out * (sign * p.normal.x) + vec3(0, p.normal.y, 0);
        const std::uint32_t id = pen.add(at, normal, {sign * reach * share, p.length});
        if (i == 0) {
            first = id;
        }
    }
    return first;
}

} // namespace

void draw_rect_sweep(Pen& pen, const Profile& profile, const RectSweep& sweep)
{
    const auto count = static_cast<std::uint32_t>(profile.size());
    const std::array<Leg, 4> legs{{{{0, 0, 1}, {1, 0, 0}, sweep.half_z, sweep.half_x},
                                   {{1, 0, 0}, {0, 0, -1}, sweep.half_x, sweep.half_z},
                                   {{0, 0, -1}, {-1, 0, 0}, sweep.half_z, sweep.half_x},
                                   {{-1, 0, 0}, {0, 0, 1}, sweep.half_x, sweep.half_z}}};
    const float cut = sweep.inwards ? 0.0f : sweep.chamfer;
    for (std::size_t k = 0; k < 4; ++k) {
        std::uint32_t previous = sweep_column(pen, profile, sweep, legs[k], -1, cut);
        for (int i = 1; i <= sweep.pieces; ++i) {
            const float share = -1 + 2 * static_cast<float>(i) / static_cast<float>(sweep.pieces);
            const std::uint32_t next = sweep_column(pen, profile, sweep, legs[k], share, cut);
            pen.strip(previous, next, count);
            previous = next;
        }
        if (cut > 0) {
            pen.strip(previous, sweep_column(pen, profile, sweep, legs[(k + 1) % 4], -1, cut), count);
        }
    }
}

void draw_straight_sweep(Pen& pen, const Profile& profile, float from, float to, int pieces, bool caps)
{
    std::uint32_t previous = 0;
    for (int i = 0; i <= pieces; ++i) {
        const float x = from + (to - from) * static_cast<float>(i) / static_cast<float>(pieces);
        std::uint32_t row = 0;
        for (std::size_t j = 0; j < profile.size(); ++j) {
            const ProfilePoint& p = profile[j];
            const std::uint32_t id = pen.add({x, p.at.y, p.at.x}, {0, p.normal.y, p.normal.x}, {x, p.length});
            if (j == 0) {
                row = id;
            }
        }
        if (i > 0) {
            pen.strip(previous, row, static_cast<std::uint32_t>(profile.size()));
        }
        previous = row;
    }
    if (!caps) {
        return;
    }
    for (const float x : {from, to}) {
        const vec3 normal(x == from ? -1 : 1, 0, 0);
        std::uint32_t hub = 0;
        for (std::size_t j = 0; j < profile.size(); ++j) {
            const vec2 p = profile[j].at;
            const std::uint32_t id = pen.add({x, p.y, p.x}, normal, {p.x, p.y});
            if (j == 0) {
                hub = id;
            }
            if (j > 1) {
                pen.triangle(hub, id - 1, id);
            }
        }
    }
}

void draw_disc(Pen& pen, float y, float inner, float outer, int segments)
{
    std::uint32_t previous = 0;
    for (int i = 0; i <= segments; ++i) {
        const float angle = 2 * pi * static_cast<float>(i) / static_cast<float>(segments);
        const vec2 way(std::sin(angle), std::cos(angle));
        const std::uint32_t id = pen.add({outer * way.x, y, outer * way.y}, {0, 1, 0}, {outer * way.x, -outer * way.y});
        pen.add({inner * way.x, y, inner * way.y}, {0, 1, 0}, {inner * way.x, -inner * way.y});
        if (i > 0) {
            pen.strip(previous, id, 2);
        }
        previous = id;
    }
}

} // namespace atrium::courtyard
