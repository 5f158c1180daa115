// Limestone in blocks, limestone cut smooth, the columns' stone, and the dark slabs of the court's border.
#include "assetconv/courtyard/textures/textures.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {
namespace {

const vec3 cream = rgb(0xDCCBA8), honey = rgb(0xC9AE80), pale = rgb(0xE6DBC2), umber = rgb(0x8A7757),
           moss = rgb(0x6C743C);

/// Grain of limestone: -1 to 1, with small pits.
float limestone_grain(const Noise& noise, vec2 uv, int frequency)
{
    const float pits = ramp(0.22f, 0.08f, noise.worley(uv, ivec2(frequency * 3)).nearest);
    return noise.fbm(uv, frequency, 4) - 0.8f * pits;
}

} // namespace

void paint_ashlar(const Studio& studio)
{
    constexpr float tile = 2.4f;
    const Noise noise(studio.seed);
    const Bond bond{.courses = 6, .stones = 4, .shift = 0.5f, .jitter = 0.38f, .tile = vec2(tile)};
    Canvas canvas = paint(studio.size, tile, [&](vec2 uv) {
        const Stone stone = stone_at(bond, uv, studio.seed);
        const float tone = unit(stone.id), hue = unit(mix(stone.id, 1)), wear = unit(mix(stone.id, 2));
        const float broad = noise.fbm(uv, 3, 4), grain = limestone_grain(noise, uv + vec2(tone, hue), 26);
        const float chip = std::max(0.0f, noise.fbm(uv, 13, 3) - 0.14f + 0.12f * wear) * 0.05f;
        const float edge = stone.edge + 0.004f * noise.fbm(uv, 44, 2) - chip;
        const float body = ramp(0.003f, 0.014f, edge);
        const vec2 tilt(unit(mix(stone.id, 3)) - 0.5f, unit(mix(stone.id, 4)) - 0.5f);
        Texel t;
        t.height =
            body * (0.011f + 0.004f * (tone - 0.5f) + 0.012f * glm::dot(tilt, stone.within)) + 0.0022f * grain * body;
        vec3 face = glm::mix(cream, glm::mix(honey, pale, hue), 0.75f * tone);
        face *= 0.94f + 0.13f * tone + 0.07f * grain + 0.07f * broad;
        const float bed = noise.gradient(uv + vec2(hue, 0), {3, 70}); // the stone's own layers
        face *= 1 + 0.025f * bed;
        const float streak = ramp(0.05f, 0.8f, noise.fbm(uv, ivec2(36, 2), 3) + 0.35f * broad);
        face = glm::mix(face, umber, 0.3f * streak);
        const vec3 mortar = rgb(0xB8A785) * (0.9f + 0.2f * grain);
        t.color = glm::mix(mortar * 0.82f, face, body);
        const float green = ramp(0.12f, 0.5f, noise.fbm(uv, 4, 4)) * ramp(0.03f, 0.004f, edge + 0.012f * grain);
        t.color = glm::mix(t.color, moss * (0.8f + 0.3f * grain), 0.62f * green);
        t.gloss = 0.2f + 0.25f * body + 0.12f * grain - 0.15f * streak;
        return t;
    });
    weather_by_height(canvas, 0.012f, 0.55f, 0.22f);
    write_color(studio, "ashlar", canvas);
    write_normal(studio, "ashlar_normal", canvas, 1.15f);
    write_gloss(studio, "ashlar_gloss", canvas);
}

void paint_limestone(const Studio& studio)
{
    constexpr float tile = 1.2f;
    const Noise noise(studio.seed);
    Canvas canvas = paint(studio.size, tile, [&](vec2 uv) {
        const float broad = noise.fbm(uv, 2, 5), grain = limestone_grain(noise, uv, 22);
        const float fine = noise.fbm(uv, 90, 2);
        const float vein = ramp(0.09f, 0.0f, noise.ridged(uv + 0.05f * vec2(broad, grain), ivec2(3), 3));
        Texel t;
        t.height = 0.0011f * grain + 0.0005f * fine - 0.0008f * vein;
        t.color =
            glm::mix(glm::mix(cream, pale, 0.32f + 0.6f * broad), honey, 0.34f * ramp(0.0f, 0.6f, noise.fbm(uv, 5, 3)));
        t.color *= 0.99f + 0.05f * grain + 0.03f * fine;
        t.color = glm::mix(t.color, umber, 0.15f * vein + 0.2f * ramp(0.05f, 0.5f, broad));
        t.gloss = 0.48f + 0.14f * grain - 0.25f * ramp(0.1f, 0.5f, broad);
        return t;
    });
    weather_by_height(canvas, 0.006f, 0.6f, 0.3f);
    write_color(studio, "limestone", canvas);
    write_normal(studio, "limestone_normal", canvas, 1.3f);
    write_gloss(studio, "limestone_gloss", canvas);
}

/// Once around the shaft and once up: its foot and neck have their own dirt.
void paint_column(const Studio& studio)
{
    constexpr float around = 1.27f, height = 2.85f;
    const Noise noise(studio.seed);
    Canvas canvas = paint(studio.size, around, [&](vec2 uv) {
        const vec2 bent = uv + 0.06f * vec2(noise.fbm(uv, ivec2(2, 4), 4), noise.fbm(uv, ivec2(3, 6), 3));
        const float cloud = noise.fbm(bent, ivec2(2, 4), 5), grain = noise.fbm(uv, ivec2(30, 66), 3);
        const float vein = ramp(0.11f, 0.0f, noise.ridged(bent, ivec2(2, 5), 4));
        const float streak = ramp(0.0f, 0.6f, noise.fbm(uv, ivec2(22, 2), 3)) * ramp(0.35f, 1.0f, uv.y);
        const float splash = ramp(0.2f, 0.0f, uv.y + 0.06f * noise.fbm(uv, ivec2(8, 16), 4));
        Texel t;
        t.color = glm::mix(rgb(0xD6B79A), rgb(0xE8D8BF), ramp(-0.4f, 0.5f, cloud));
        t.color = glm::mix(t.color, rgb(0xB08468), 0.5f * vein) * (1 + 0.04f * grain);
        t.color = glm::mix(t.color, umber, 0.3f * streak);
        t.color = glm::mix(t.color, glm::mix(umber, moss, 0.35f), 0.55f * splash * (0.7f + 0.3f * grain));
        t.height = 0.0007f * grain - 0.0012f * vein;
        t.gloss = 0.72f - 0.5f * splash - 0.3f * streak + 0.1f * grain;
        return t;
    });
    write_color(studio, "column", canvas);
    write_normal(studio, "column_normal", canvas, 1.2f, height / around);
    write_gloss(studio, "column_gloss", canvas);
}

void paint_basalt(const Studio& studio)
{
    constexpr float tile = 1.6f;
    const Noise noise(studio.seed);
    Canvas canvas = paint(studio.size, tile, [&](vec2 uv) {
        const float broad = noise.fbm(uv, 3, 4), grain = noise.fbm(uv, 40, 4);
        const float polish = ramp(-0.1f, 0.4f, noise.fbm(uv, 2, 3)); // where feet go
        const float scratch = ramp(0.05f, 0.0f, noise.ridged(uv, {5, 9}, 2));
        Texel t;
        t.color = glm::mix(rgb(0x6E675E), rgb(0x8C8474), 0.5f + 0.7f * broad) * (1 + 0.1f * grain);
        t.color = glm::mix(t.color, rgb(0xA99E8A), 0.3f * scratch);
        t.height = 0.0016f * grain * (1.2f - polish) - 0.0006f * scratch;
        t.gloss = 0.35f + 0.4f * polish + 0.1f * grain;
        return t;
    });
    weather_by_height(canvas, 0.008f, 0.5f, 0.3f);
    write_color(studio, "basalt", canvas);
    write_normal(studio, "basalt_normal", canvas, 1.2f);
    write_gloss(studio, "basalt_gloss", canvas);
}

} // namespace atrium::courtyard
