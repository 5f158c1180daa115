// Heavy cloth: one width of a metre, as high as the hanging; the embroidered border is at its foot. Three hues.
#include "assetconv/courtyard/textures/textures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atrium::courtyard {
namespace {

struct Hue {
    const char* name;
    vec3 ground, figure;
};

const std::array<Hue, 3> hues{{{"cloth_red", rgb(0x8A2A27), rgb(0xA03B31)},
                               {"cloth_green", rgb(0x4A5E3C), rgb(0x6A7F50)},
                               {"cloth_blue", rgb(0x35506F), rgb(0x466685)}}};
const vec3 gold = rgb(0xD0AA5E);

/// A flower of `petals` about the origin; 1 inside.
float flower(vec2 p, float radius, float petals)
{
    const float r = glm::length(p), a = std::atan2(p.y, p.x);
    const float reach = radius * (0.62f + 0.38f * std::cos(petals * a));
    const float ring = ramp(0.3f * radius, 0.24f * radius, r) - ramp(0.2f * radius, 0.15f * radius, r);
    return std::max(ramp(reach, 0.85f * reach, r) * ramp(0.3f * radius, 0.36f * radius, r), ring);
}

/// The woven figure: an ogee lattice with a flower in each field. p in fields.
float damask(vec2 p)
{
    const float row = std::floor(p.y);
    const vec2 field(glm::fract(p.x + 0.5f * (static_cast<int>(row) % 2 != 0 ? 1.0f : 0.0f)) - 0.5f,
                     glm::fract(p.y) - 0.5f);
    const float swing = 0.25f + 0.22f * std::cos(2 * pi * p.y * 0.5f);
    const float lattice_x = glm::fract(p.x) - 0.5f;
    const float lattice = ramp(0.055f, 0.03f, std::abs(std::abs(lattice_x) - swing));
    return std::max(lattice, std::max(flower(field * vec2(1, 1.15f), 0.27f, 6),
                                      ramp(0.07f, 0.05f, glm::length(glm::abs(field) - vec2(0, 0.42f)))));
}

/// The border's embroidery: lines, and between them a running scroll with leaves. h: 0 at its foot, 1 at its top.
float border(float u, float h)
{
    float thread = 0;
    for (const float line : {0.1f, 0.16f, 0.86f, 0.93f}) {
        thread = std::max(thread, ramp(0.026f, 0.016f, std::abs(h - line)));
    }
    const float x = 5 * u, wave = 0.5f + 0.17f * std::sin(2 * pi * x);
    if (h > 0.19f && h < 0.83f) {
        thread = std::max(thread, ramp(0.05f, 0.03f, std::abs(h - wave)));
        const vec2 in(glm::fract(2 * x) - 0.5f, 0);
        const bool high = static_cast<int>(std::floor(2 * x)) % 2 == 0; // a flower in each bend
        thread = std::max(thread, flower(vec2(in.x * 0.5f, h - (high ? 0.36f : 0.64f)) * vec2(0.9f, 1), 0.15f, 5));
    }
    return thread;
}

struct Weave {
    float figure, gold_thread, height, shade;
};

Weave weave_at(const Noise& noise, vec2 uv, int size)
{
    Weave w{};
    constexpr float border_top = 0.115f, fringe_top = 0.012f;
    const int threads = size / 4; // four texels a thread: finer would alias
    const float warp = std::sin(2 * pi * uv.x * static_cast<float>(threads)),
                weft = std::sin(2 * pi * uv.y * static_cast<float>(threads));
    w.height = 0.0004f * warp * weft;
    w.shade =
        1 + 0.035f * warp * weft + 0.06f * noise.fbm(uv, ivec2(3, 5), 4) + 0.03f * noise.fbm(uv, ivec2(120, 30), 2);
    if (uv.y < fringe_top) {
        w.gold_thread = 1;
        w.shade *= 0.75f + 0.25f * std::sin(2 * pi * uv.x * 90);
    } else if (uv.y < border_top) {
        w.gold_thread = border(uv.x, (uv.y - fringe_top) / (border_top - fringe_top));
    } else if (uv.y > 0.975f) {
        w.gold_thread = ramp(0.004f, 0.003f, std::abs(uv.y - 0.985f));
    } else {
        w.figure = damask({uv.x * 4, (uv.y - border_top) * 14});
    }
    const float stitches = 0.8f + 0.2f * std::sin(2 * pi * (uv.x + uv.y) * static_cast<float>(threads));
    w.height += 0.0013f * w.gold_thread * stitches + 0.0004f * w.figure;
    w.shade *= 1 - 0.22f * ramp(0.09f, 0.0f, uv.y); // dust at the hem
    return w;
}

} // namespace

void paint_cloth(const Studio& studio)
{
    const Noise noise(studio.seed);
    bool first = true;
    for (const Hue& hue : hues) {
        const Canvas canvas = paint(studio.size, 1, [&](vec2 uv) {
            const Weave w = weave_at(noise, uv, studio.size);
            Texel t;
            t.color = glm::mix(hue.ground, hue.figure, 0.7f * w.figure) * w.shade;
            if (uv.y > 0.012f && uv.y < 0.115f) {
                t.color *= 0.82f;
            } // the border's ground is darker
            t.color = glm::mix(t.color, gold * w.shade, 0.88f * w.gold_thread);
            t.height = w.height;
            return t;
        });
        write_color(studio, hue.name, canvas);
        if (first) {
            write_normal(studio, "cloth_normal", canvas, 0.9f, 2);
        }
        first = false;
    }
}

} // namespace atrium::courtyard
