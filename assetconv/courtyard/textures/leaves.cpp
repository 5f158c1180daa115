// The two atlases, two by two cells, in the order of leaves.hpp: single leaves and blossoms with a separate mask,
// fronds and racemes with alpha in the colour.
#include "assetconv/courtyard/textures/textures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atrium::courtyard {
namespace {

/// A point of a cell: x from -1 to 1, y from 0 at the foot to 1; `soft`: half a texel, to smooth edges.
struct Spot {
    vec2 at;
    float soft;
};

/// 1 inside, where distance is positive.
float inside(float distance, float soft)
{
    return ramp(-soft, soft, distance);
}

vec3 vein_color(vec3 leaf, vec3 vein, float strength)
{
    return glm::mix(leaf, vein, glm::clamp(strength, 0.0f, 1.0f));
}

Texel ivy(const Spot& s, const Noise& noise)
{
    const vec2 p = s.at - vec2(0, 0.36f);
    const float r = glm::length(p * vec2(0.62f, 1)), a = std::atan2(p.x * 0.62f, p.y);
    const std::array<float, 5> lobes{0.0f, 1.05f, -1.05f, 2.15f, -2.15f}, lengths{0.61f, 0.5f, 0.5f, 0.35f, 0.35f};
    float reach = 0.19f, vein = 0;
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        const float off = std::abs(a - lobes[i]);
        reach = std::max(reach, lengths[i] * (1 - std::pow(std::min(1.0f, off / 0.62f), 1.3f) * 0.68f));
        vein = std::max(vein, ramp(0.022f, 0.006f, r * std::sin(std::min(off, 1.5f))) * ramp(lengths[i], 0.0f, r));
    }
    if (std::abs(a) > 2.75f) {
        reach *= 1 - 2.0f * (std::abs(a) - 2.75f);
    } // the notch at the stalk
    Texel t;
    const float stalk = 0.018f - std::abs(s.at.x) * 0.6f;
    t.alpha = std::max(inside(reach - r, s.soft), s.at.y < 0.36f ? inside(stalk, s.soft) : 0.0f);
    const vec3 leaf =
        glm::mix(rgb(0x4C7A33), rgb(0x315823), ramp(0.1f, 0.5f, r)) * (1 + 0.15f * noise.fbm(s.at * 0.5f, 9, 3));
    t.color = vein_color(leaf, rgb(0xA3BC74), 0.65f * vein);
    return t;
}

/// A pointed oval, `wide` at its broadest.
Texel oval(const Spot& s, float wide, vec3 dark, vec3 light)
{
    const float along = glm::clamp((s.at.y - 0.04f) / 0.94f, 0.0f, 1.0f);
    const float half = wide * std::pow(std::sin(pi * std::pow(along, 0.85f)), 0.8f);
    Texel t;
    const float stalk = 0.03f - std::abs(s.at.x);
    t.alpha = std::max(inside((half - std::abs(s.at.x)) * 0.5f, s.soft), s.at.y < 0.1f ? inside(stalk, s.soft) : 0.0f);
    const float rib = ramp(0.05f, 0.015f, std::abs(s.at.x));
    const float side = ramp(0.86f, 0.97f, std::sin(2 * pi * 7 * (s.at.y - 0.35f * std::abs(s.at.x))));
    t.color = glm::mix(dark, light, 0.4f + 0.35f * std::abs(s.at.x) + 0.25f * s.at.y);
    t.color = vein_color(t.color, light * 1.25f, 0.55f * rib + 0.22f * side);
    return t;
}

Texel geranium(const Spot& s, const Noise& noise)
{
    const vec2 p = vec2(s.at.x * 0.5f, s.at.y - 0.5f);
    const float r = glm::length(p), a = std::atan2(p.x, p.y);
    float reach = 0.42f + 0.035f * std::cos(7 * a) + 0.015f * std::cos(35 * a);
    if (std::abs(a) > 2.7f) {
        reach *= 1 - 1.6f * (std::abs(a) - 2.7f);
    }
    Texel t;
    t.alpha = inside(reach - r, s.soft);
    t.color = glm::mix(rgb(0x6B9444), rgb(0x4C7A38), ramp(0.1f, 0.42f, r)) * (1 + 0.1f * noise.fbm(s.at * 0.5f, 8, 3));
    t.color = glm::mix(t.color, rgb(0x3C5A2C), 0.55f * ramp(0.07f, 0.02f, std::abs(r - 0.24f))); // the dark zone
    t.color = vein_color(t.color, rgb(0x9DBB6C), 0.4f * ramp(0.97f, 1.0f, std::cos(7 * a)) * ramp(0.4f, 0.1f, r));
    return t;
}

/// A head of blossoms, five petals each.
Texel blossom(const Spot& s, const Noise& noise)
{
    Texel t;
    t.alpha = 0;
    t.color = rgb(0xB32A2A);
    float best = -1;
    for (int i = 0; i < 13; ++i) {
        const float turn = 2.39996f * static_cast<float>(i), away = 0.1f * std::sqrt(static_cast<float>(i));
        const vec2 middle(away * std::cos(turn), 0.5f + away * std::sin(turn));
        const vec2 p = vec2(s.at.x * 0.5f, s.at.y) - middle;
        const float r = glm::length(p), a = std::atan2(p.y, p.x) + turn;
        const float petal = 0.105f * (0.72f + 0.28f * std::cos(5 * a)) - r;
        const float order = petal > 0 ? noise.cell(i, 2) : -1.0f; // who lies on top
        t.alpha = std::max(t.alpha, inside(petal, s.soft));
        if (order > best) {
            best = order;
            t.color = glm::mix(rgb(0xE0584A), rgb(0xB42325), noise.cell(i, 1)) * (0.75f + 3.0f * r);
            t.color = glm::mix(t.color, rgb(0xF0C98A), ramp(0.02f, 0.01f, r));
        }
    }
    return t;
}

/// Leaflets in pairs along a rib: `pairs` of them, leaning by `lean`, as long as `reach` says.
struct Pinnae {
    float pairs, lean, fill;
    float longest;
    vec3 dark, light;
};

Texel pinnate(const Spot& s, const Pinnae& f)
{
    const float x = std::abs(s.at.x), foot = s.at.y - f.lean * x;
    const float share = glm::clamp((foot - 0.06f) / 0.86f, 0.0f, 1.0f);
    const float reach = f.longest * std::pow(std::sin(pi * (0.12f + 0.86f * std::pow(share, 0.9f))), 0.75f);
    const float index = foot * f.pairs + (s.at.x < 0 ? 0.5f : 0.0f), within = std::abs(glm::fract(index) - 0.5f);
    const float along = glm::clamp(x / std::max(0.01f, reach), 0.0f, 1.2f);
    const float half = 0.5f * f.fill * std::pow(std::max(0.0f, std::sin(pi * (0.08f + 0.92f * along))), 0.6f);
    Texel t;
    float shape = along < 1 && foot > 0.05f && foot < 0.95f ? inside((half - within) / f.pairs, s.soft) : 0.0f;
    const float rib = 0.03f * (1 - 0.7f * s.at.y) - x;
    if (s.at.y < 0.95f) {
        shape = std::max(shape, inside(rib, s.soft));
    }
    t.alpha = shape;
    t.color = glm::mix(f.dark, f.light,
                       0.25f + 0.5f * along + 0.3f * unit(mix(static_cast<std::uint32_t>(std::max(0.0f, index)), 5)));
    t.color = vein_color(t.color, f.light * 1.2f, 0.5f * ramp(0.06f, 0.0f, within));
    if (rib > 0) {
        t.color = glm::mix(rgb(0x6F7A3E), rgb(0x8A9450), s.at.y);
    }
    return t;
}

Texel raceme(const Spot& s, const Noise& noise)
{
    const float half = 0.92f * std::pow(1 - glm::clamp(s.at.y, 0.0f, 1.0f), 0.55f) * ramp(0.0f, 0.12f, s.at.y);
    const Noise::Cell floret = noise.worley({0.5f * s.at.x + 0.5f, s.at.y}, ivec2(7, 16));
    const float fall = (half - std::abs(s.at.x)) * 0.5f;
    Texel t;
    t.alpha = inside(std::min(0.5f - floret.nearest, fall * 8) / 12, s.soft);
    if (std::abs(s.at.x) < 0.03f && s.at.y < 0.9f) {
        t.alpha = 1;
    }
    const float tone = unit(floret.id);
    t.color = glm::mix(glm::mix(rgb(0xC3AEE3), rgb(0x9C7FCB), tone), rgb(0x6E4FA6), ramp(0.3f, 1.0f, s.at.y) * 0.75f);
    t.color *= 1.1f - 0.5f * floret.nearest;
    t.color = glm::mix(t.color, rgb(0xF3EBD2), ramp(0.16f, 0.08f, glm::length(floret.offset - vec2(0, 0.1f))) * 0.7f);
    return t;
}

Texel agave(const Spot& s, const Noise& noise)
{
    const float y = glm::clamp(s.at.y, 0.0f, 1.0f);
    const float half = 0.72f * std::pow(1 - y, 0.6f) * (0.62f + 0.75f * y),
                tooth = 0.035f * std::abs(glm::fract(y * 15) - 0.5f);
    Texel t;
    t.alpha = inside((half + tooth - std::abs(s.at.x)) * 0.5f, s.soft);
    t.color =
        glm::mix(rgb(0x6D9079), rgb(0x86A98C), 0.5f + 0.5f * noise.fbm({0.5f * s.at.x + 0.5f, y}, ivec2(14, 2), 3));
    t.color *= 0.8f + 0.25f * std::abs(s.at.x) / std::max(0.05f, half);
    t.color = glm::mix(t.color, rgb(0xCFC98A), ramp(0.12f, 0.05f, half - std::abs(s.at.x)));
    return t;
}

/// One of several leaves in a cell.
struct Placed {
    vec2 foot;
    float turn, scale; ///< radians clockwise from upright; share of the cell
};

/// Several leaves, the later ones on top, each a little lighter or darker, on a common stalk up to `stalk`.
template <typename Painter>
Texel sprig(const Spot& s, const std::vector<Placed>& leaves, float stalk, const Painter& painter)
{
    const vec2 p(0.5f * s.at.x, s.at.y);
    Texel t;
    t.alpha = s.at.y < stalk ? inside(0.012f - std::abs(p.x), s.soft) : 0.0f;
    t.color = rgb(0x5E6E38);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const Placed& leaf = leaves[i];
        const vec2 away = (p - leaf.foot) / leaf.scale;
        if (glm::dot(away, away) > 1.3f) {
            continue;
        }
        const float c = std::cos(leaf.turn), sn = std::sin(leaf.turn);
        const vec2 q(c * away.x - sn * away.y, sn * away.x + c * away.y);
        if (q.y < 0 || q.y > 1 || std::abs(q.x) > 0.5f) {
            continue;
        }
        const Texel one = painter(Spot{{2 * q.x, q.y}, s.soft / leaf.scale});
        const float shade = 0.84f + 0.3f * unit(mix(static_cast<std::uint32_t>(i), 77));
        t.color = glm::mix(t.color, one.color * shade,
                           one.alpha > 0.02f ? std::max(one.alpha, t.alpha < 0.02f ? 1.0f : 0.0f) : 0.0f);
        t.alpha = std::max(t.alpha, one.alpha);
    }
    return t;
}

template <typename Painter>
Canvas paint_cells(const Studio& studio, const std::array<Painter, 4>& painters)
{
    const float soft = 2.0f / static_cast<float>(studio.size);
    return paint(studio.size, 1, [&](vec2 uv) {
        const ivec2 cell = glm::min(ivec2(uv * 2.0f), ivec2(1));
        const vec2 within = uv * 2.0f - vec2(cell);
        Texel t = painters[static_cast<std::size_t>(cell.x) + 2 * static_cast<std::size_t>(cell.y)](
            Spot{{2 * within.x - 1, within.y}, soft});
        // A clear margin: no leaf bleeds into its neighbour's mips too soon.
        const vec2 margin = glm::min(within, 1.0f - within);
        t.alpha *= ramp(0.0f, 0.012f, std::min(margin.x, margin.y));
        return t;
    });
}

} // namespace

void paint_leaf_atlas(const Studio& studio)
{
    const Noise noise(studio.seed);
    const std::vector<Placed> ivy_leaves{{{0, 0.04f}, -0.35f, 0.38f}, {{0, 0.1f}, 1.2f, 0.44f},
                                         {{0, 0.16f}, -1.25f, 0.46f}, {{0, 0.34f}, 0.95f, 0.45f},
                                         {{0, 0.42f}, -0.9f, 0.44f},  {{0, 0.56f}, 0.1f, 0.42f}};
    const std::vector<Placed> citrus_leaves{
        {{0, 0.03f}, 1.2f, 0.42f}, {{0, 0.06f}, -1.15f, 0.44f}, {{0, 0.22f}, 1.0f, 0.5f}, {{0, 0.28f}, -1.0f, 0.5f},
        {{0, 0.4f}, 0.75f, 0.48f}, {{0, 0.46f}, -0.7f, 0.48f},  {{0, 0.5f}, 0.05f, 0.48f}};
    const std::vector<Placed> geranium_leaves{{{-0.2f, 0.02f}, -0.2f, 0.5f},
                                              {{0.2f, 0.04f}, 0.25f, 0.52f},
                                              {{0, 0.22f}, 0.05f, 0.5f},
                                              {{-0.21f, 0.44f}, -0.1f, 0.5f},
                                              {{0.2f, 0.47f}, 0.2f, 0.48f}};
    const std::array<std::function<Texel(const Spot&)>, 4> cells{
        [&](const Spot& s) { return sprig(s, ivy_leaves, 0.6f, [&](const Spot& q) { return ivy(q, noise); }); },
        [&](const Spot& s) {
            return sprig(s, citrus_leaves, 0.5f,
                         [&](const Spot& q) { return oval(q, 0.36f, rgb(0x3B6428), rgb(0x6E9440)); });
        },
        [&](const Spot& s) {
            return sprig(s, geranium_leaves, 0.4f, [&](const Spot& q) { return geranium(q, noise); });
        },
        [&](const Spot& s) { return blossom(s, noise); },
    };
    const Canvas canvas = paint_cells(studio, cells);
    write_color(studio, "leaf_atlas", canvas);
    write_alpha(studio, "leaf_mask", canvas);
}

void paint_frond_atlas(const Studio& studio)
{
    const Noise noise(studio.seed);
    const std::array<std::function<Texel(const Spot&)>, 4> cells{
        [&](const Spot& s) {
            return pinnate(s, {22, 0.1f, 0.84f, 0.92f, rgb(0x4A7A30), rgb(0x8DB552)});
        },
        [&](const Spot& s) { return raceme(s, noise); },
        [&](const Spot& s) {
            return pinnate(s, {7, 0.16f, 0.8f, 0.9f, rgb(0x5B8A3A), rgb(0x97BC5E)});
        },
        [&](const Spot& s) { return agave(s, noise); },
    };
    write_color_alpha(studio, "frond_atlas", paint_cells(studio, cells));
}

} // namespace atrium::courtyard
