// Timber with its grain along u: beams and boards of the ceilings, planks of the doors, bark.
#include "assetconv/courtyard/textures/textures.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {
namespace {

struct Timber {
    float tile;
    int boards; ///< across the tile; 1: no joints
    vec3 early, late, grey;
    float silvering; ///< how far the surface has gone grey
};

Canvas paint_timber(const Studio& studio, const Timber& wood)
{
    const Noise noise(studio.seed);
    Canvas canvas = paint(studio.size, wood.tile, [&](vec2 uv) {
        const float across = uv.y * static_cast<float>(wood.boards);
        const int board = std::min(wood.boards - 1, static_cast<int>(across));
        const float tone = noise.cell(board, 3);
        const vec2 own = uv + vec2(noise.cell(board, 4), 0);
        const float wave = noise.fbm(own, ivec2(2, 6), 3);
        // Rings cut lengthwise: bands across that wander along the board, and knots that push them aside.
        const Noise::Cell knot = noise.worley(own, ivec2(2, 5));
        const float push = 0.5f * std::exp(-18 * knot.nearest * knot.nearest);
        const float rings = 0.5f + 0.5f * std::sin(2 * pi * (uv.y * 26 + 1.6f * wave + push * 4));
        const float fibre = noise.fbm(own, ivec2(6, 170), 3),
                    pore = ramp(0.25f, 0.6f, noise.fbm(own, ivec2(10, 220), 2));
        Texel t;
        t.color = glm::mix(wood.early, wood.late, 0.75f * rings) * (0.88f + 0.24f * tone + 0.14f * fibre);
        t.color = glm::mix(t.color, wood.late * 0.6f, 0.8f * std::exp(-60 * knot.nearest * knot.nearest));
        t.color = glm::mix(t.color, wood.grey, wood.silvering * ramp(-0.2f, 0.5f, noise.fbm(uv, ivec2(3, 9), 4)));
        const float check =
            ramp(0.035f, 0.0f, noise.ridged(own, ivec2(2, 22), 2)) * ramp(0.0f, 0.3f, wave); // drying cracks
        float joint = 0;
        if (wood.boards > 1) {
            const float edge = std::min(across - static_cast<float>(board), 1 - across + static_cast<float>(board));
            joint = ramp(0.03f, 0.008f, edge);
        }
        t.color *= 1 - 0.6f * check - 0.7f * joint;
        t.height = 0.0012f * fibre + 0.0008f * rings - 0.0012f * pore - 0.003f * check - 0.008f * joint;
        t.gloss = 0.4f + 0.2f * fibre - 0.3f * check - 0.2f * pore;
        return t;
    });
    weather_by_height(canvas, 0.006f, 0.5f, 0.25f);
    return canvas;
}

} // namespace

void paint_wood_beam(const Studio& studio)
{
    const Canvas canvas = paint_timber(studio, {1.6f, 8, rgb(0x8A6442), rgb(0x654328), rgb(0x87765F), 0.3f});
    write_color(studio, "wood_beam", canvas);
    write_normal(studio, "wood_beam_normal", canvas, 1.2f);
}

void paint_wood_door(const Studio& studio)
{
    const Canvas canvas = paint_timber(studio, {1.2f, 1, rgb(0x94653F), rgb(0x6A4026), rgb(0x94846C), 0.35f});
    write_color(studio, "wood_door", canvas);
    write_normal(studio, "wood_door_normal", canvas, 1.2f);
    write_gloss(studio, "wood_door_gloss", canvas);
}

/// Painted wood: the paint has gone where the grain stands up.
void paint_shutter(const Studio& studio)
{
    const Noise noise(studio.seed + 1);
    Canvas canvas = paint_timber(studio, {1.2f, 1, rgb(0x94653F), rgb(0x6A4026), rgb(0x94846C), 0.7f});
    for (int y = 0; y < canvas.size; ++y) {
        for (int x = 0; x < canvas.size; ++x) {
            Texel& t = canvas.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.size) +
                                     static_cast<std::size_t>(x)];
            const vec2 uv = (vec2(x, y) + 0.5f) / static_cast<float>(canvas.size);
            const float broad = noise.fbm(uv, ivec2(4, 8), 4);
            const float coat = ramp(0.42f, 0.3f, broad + 90 * t.height);
            const vec3 green =
                glm::mix(rgb(0x6C9484), rgb(0x557A6B), 0.5f + broad) * (1 + 0.08f * noise.fbm(uv, ivec2(6, 120), 2));
            t.color = glm::mix(t.color, green, coat);
            t.height += 0.0006f * coat;
        }
    }
    write_color(studio, "shutter", canvas);
    write_normal(studio, "shutter_normal", canvas, 1.2f);
}

void paint_bark(const Studio& studio)
{
    constexpr float tile = 0.5f;
    const Noise noise(studio.seed);
    Canvas canvas = paint(studio.size, tile, [&](vec2 uv) {
        const float furrow = noise.ridged(uv + 0.03f * vec2(noise.fbm(uv, 4, 3)), ivec2(9, 3), 3),
                    grain = noise.fbm(uv, 40, 3);
        Texel t;
        t.color = glm::mix(rgb(0x4B3B2C), rgb(0x8A7760), ramp(0.05f, 0.6f, furrow)) * (1 + 0.15f * grain);
        t.color = glm::mix(t.color, rgb(0x6F7348), 0.35f * ramp(0.1f, 0.5f, noise.fbm(uv, 4, 3)));
        t.height = 0.006f * ramp(0.0f, 0.5f, furrow) + 0.001f * grain;
        return t;
    });
    write_color(studio, "bark", canvas);
    write_normal(studio, "bark_normal", canvas);
}

} // namespace atrium::courtyard
