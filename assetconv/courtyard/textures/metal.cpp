// Iron, bronze, chains; and the small rest: glass, water, soil, oranges.
#include "assetconv/courtyard/textures/textures.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {

void paint_iron(const Studio& studio)
{
    const Noise noise(studio.seed);
    const Canvas canvas = paint(studio.size, 0.5f, [&](vec2 uv) {
        const float hammer = noise.worley(uv, ivec2(11)).nearest, grain = noise.fbm(uv, 40, 3);
        const float rust = ramp(0.08f, 0.45f, noise.fbm(uv, 5, 4));
        Texel t;
        t.color = glm::mix(rgb(0x4A4744) * (1 + 0.1f * grain), rgb(0x7A4A30) * (1 + 0.2f * grain), 0.75f * rust);
        t.height = 0.002f * hammer * hammer + 0.0005f * grain + 0.0004f * rust;
        t.gloss = 0.45f + 0.35f * rust + 0.12f * grain; // roughness
        return t;
    });
    write_color(studio, "iron", canvas);
    write_normal(studio, "iron_normal", canvas);
    write_gloss(studio, "iron_rough", canvas);
}

void paint_bronze(const Studio& studio)
{
    const Noise noise(studio.seed);
    const Canvas canvas = paint(studio.size, 0.5f, [&](vec2 uv) {
        const float grain = noise.fbm(uv, 30, 4), verdigris = ramp(0.02f, 0.4f, noise.fbm(uv, 4, 5));
        Texel t;
        t.color = glm::mix(rgb(0x9C7440) * (1 + 0.12f * grain), rgb(0x6A9A86), 0.7f * verdigris);
        t.height = 0.0006f * grain + 0.0004f * verdigris;
        t.gloss = 0.32f + 0.45f * verdigris + 0.1f * grain;
        return t;
    });
    write_color(studio, "bronze", canvas);
    write_normal(studio, "bronze_normal", canvas);
    write_gloss(studio, "bronze_rough", canvas);
}

/// Four links: two seen from the front as rings, two from the side as bars.
void paint_chain(const Studio& studio)
{
    const Noise noise(studio.seed);
    const Canvas canvas = paint(studio.size, 0.24f, [&](vec2 uv) {
        const float soft = 1.0f / static_cast<float>(studio.size);
        const float x = 2 * uv.x - 1;
        Texel t;
        t.alpha = 0;
        float round = 0;
        for (int link = -1; link <= 4; ++link) {
            const float y = uv.y - 0.25f * (static_cast<float>(link) + 0.5f);
            const bool front = link % 2 == 0;
            float distance;
            if (front) {
                const float r = glm::length(vec2(x / 0.62f, y / 0.165f));
                distance = 0.3f - std::abs(r - 0.75f);
            } else {
                distance = std::min(0.2f - std::abs(x), (0.17f - std::abs(y)) * 2);
            }
            t.alpha = std::max(t.alpha, ramp(-6 * soft, 6 * soft, distance));
            round = std::max(round, distance);
        }
        t.color = rgb(0x5A5148) * (0.6f + 1.6f * glm::clamp(round, 0.0f, 0.3f) + 0.15f * noise.fbm(uv, 12, 3));
        return t;
    });
    write_color(studio, "chain", canvas);
    write_alpha(studio, "chain_mask", canvas);
}

void paint_glass(const Studio& studio)
{
    const Noise noise(studio.seed);
    write_color(studio, "glass_glow", paint(studio.size, 0.4f, [&](vec2 uv) {
                    Texel t;
                    t.color = glm::mix(rgb(0xFFD79A), rgb(0xF2A65A), 0.5f + 0.8f * noise.fbm(uv, 3, 4));
                    t.color *= 0.93f + 0.1f * noise.fbm(uv, 16, 2);
                    return t;
                }));
}

void paint_water(const Studio& studio)
{
    const Noise noise(studio.seed);
    const Canvas canvas = paint(studio.size, 1.6f, [&](vec2 uv) {
        Texel t;
        t.color = glm::mix(rgb(0x22352F), rgb(0x33493D), 0.5f + 0.6f * noise.fbm(uv, 3, 4));
        t.height = 0.012f * noise.fbm(uv + 0.04f * vec2(noise.fbm(uv, 4, 2)), 6, 3);
        return t;
    });
    write_color(studio, "water", canvas);
    write_normal(studio, "water_normal", canvas);
}

void paint_soil(const Studio& studio)
{
    const Noise noise(studio.seed);
    const Canvas canvas = paint(studio.size, 0.5f, [&](vec2 uv) {
        const Noise::Cell crumb = noise.worley(uv, ivec2(16));
        const float grain = noise.fbm(uv, 24, 3);
        Texel t;
        t.color = glm::mix(rgb(0x3A2C20), rgb(0x6B543C), unit(crumb.id)) * (1.1f - 0.5f * crumb.nearest + 0.2f * grain);
        t.height = 0.012f * (1 - crumb.nearest) + 0.004f * grain;
        return t;
    });
    write_color(studio, "soil", canvas);
    write_normal(studio, "soil_normal", canvas);
}

void paint_orange(const Studio& studio)
{
    const Noise noise(studio.seed);
    const Canvas canvas = paint(studio.size, 0.3f, [&](vec2 uv) {
        const float pore = ramp(0.5f, 0.1f, noise.worley(uv, ivec2(34)).nearest);
        Texel t;
        t.color = glm::mix(rgb(0xE08A2C), rgb(0xD9701F), 0.5f + 0.8f * noise.fbm(uv, 3, 3)) * (1 - 0.12f * pore);
        t.height = -0.0007f * pore;
        return t;
    });
    write_color(studio, "orange", canvas);
    write_normal(studio, "orange_normal", canvas);
}

} // namespace atrium::courtyard
