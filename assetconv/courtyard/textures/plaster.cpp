// Plaster over brick, a storey high: foot and head of the wall are foot and head of the picture.
#include "assetconv/courtyard/plan.hpp"
#include "assetconv/courtyard/textures/textures.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {
namespace {

struct Coat {
    vec3 light, deep, patch; ///< fresh, weathered and mended plaster
    float bareness;          ///< how much brick shows; larger is more
    bool dado;               ///< a painted band below, as high as a chair's back and a half
};

vec3 brick_color(const Noise& noise, const Stone& brick, vec2 uv, float face)
{
    const float tone = unit(brick.id);
    vec3 c = glm::mix(rgb(0x9E5238), rgb(0xBC7A52), tone);
    if (unit(mix(brick.id, 5)) < 0.15f) {
        c = rgb(0x7C4636);
    }
    c *= 0.9f + 0.25f * noise.fbm(uv, 120, 2);
    return glm::mix(rgb(0xB3A183), c, face);
}

vec3 coat_color(const Coat& coat, const Noise& noise, vec2 uv, float broad)
{
    vec3 c = glm::mix(coat.light, coat.deep, ramp(-0.5f, 0.6f, broad + 0.35f * noise.fbm(uv, 12, 4)));
    c = glm::mix(c, coat.patch, 0.4f * ramp(0.25f, 0.3f, noise.fbm(uv + vec2(0.31f, 0.77f), 3, 3)));
    c *= 1 + 0.05f * noise.fbm(uv, 60, 3);
    if (!coat.dado) {
        return c;
    }
    const float metres = uv.y * plaster_tile + 0.006f * noise.fbm(uv, 30, 2);
    const float worn = ramp(0.1f, 0.55f, noise.fbm(uv, 9, 5) + 0.25f * ramp(0.5f, 0.0f, metres));
    const vec3 red = glm::mix(rgb(0x99503C), rgb(0x7F3F33), 0.5f + 0.6f * noise.fbm(uv, 7, 4));
    c = glm::mix(c, red, ramp(1.265f, 1.255f, metres) * (1 - 0.7f * worn));
    const float line = ramp(0.011f, 0.008f, std::abs(metres - 1.31f)) * (1 - 0.8f * worn);
    return glm::mix(c, rgb(0x7A4034), line);
}

Canvas paint_coat(const Studio& studio, const Coat& coat)
{
    const Noise noise(studio.seed);
    const Bond bond{.courses = 64, .stones = 20, .shift = 0.5f, .jitter = 0.06f, .tile = vec2(plaster_tile)};
    Canvas canvas = paint(studio.size, plaster_tile, [&](vec2 uv) {
        const float broad = noise.fbm(uv, 3, 5), fine = noise.fbm(uv, 70, 3);
        const float foot = ramp(0.11f, 0.0f, uv.y), head = ramp(0.93f, 1.0f, uv.y);
        const float loss = noise.fbm(uv + vec2(0.13f, 0.41f), 3, 6) + 0.12f * noise.fbm(uv + vec2(0.6f, 0.2f), 2, 2) +
                           0.2f * foot + 0.06f * head + coat.bareness;
        const float bare = ramp(0.395f, 0.405f, loss), lip = ramp(0.34f, 0.4f, loss) * (1 - bare);
        const Stone brick = stone_at(bond, uv, studio.seed + 3);
        const float face = ramp(0.002f, 0.009f, brick.edge + 0.002f * fine);
        const Noise::Cell crack_cell = noise.worley(uv + 0.02f * vec2(noise.fbm(uv, 9, 3), fine * 0.4f), ivec2(4));
        const float crack =
            ramp(0.014f, 0.003f, crack_cell.second - crack_cell.nearest) * ramp(-0.05f, 0.25f, broad) * (1 - bare);
        Texel t;
        const float plaster_height = 0.016f + 0.003f * broad + 0.0016f * fine + 0.004f * lip - 0.005f * crack;
        t.height = glm::mix(plaster_height, 0.006f * face + 0.001f * fine, bare);
        t.color = glm::mix(coat_color(coat, noise, uv, broad), brick_color(noise, brick, uv, face), bare);
        t.color = glm::mix(t.color, coat.light * 1.06f, 0.35f * lip);
        t.color = glm::mix(t.color, rgb(0x6E5A44), 0.55f * crack);
        const float run = noise.fbm(uv, ivec2(34, 1), 3) + 0.5f * noise.gradient(uv, {7, 1});
        const float streak = ramp(0.0f, 0.75f, run) * ramp(0.45f, 1.0f, uv.y + 0.15f * broad);
        t.color = glm::mix(t.color, rgb(0x6B5B47), 0.42f * streak);
        const float damp = ramp(0.13f, 0.0f, uv.y + 0.09f * noise.fbm(uv, 8, 4));
        t.color = glm::mix(t.color, rgb(0x6D6346), 0.5f * damp);
        t.color = glm::mix(t.color, rgb(0x7A7B50), 0.35f * damp * ramp(0.0f, 0.4f, noise.fbm(uv, 14, 4)));
        t.gloss = 0.3f + 0.15f * fine - 0.15f * bare + 0.15f * damp;
        return t;
    });
    weather_by_height(canvas, 0.02f, 0.6f, 0.25f);
    return canvas;
}

} // namespace

void paint_plaster(const Studio& studio)
{
    const Canvas canvas = paint_coat(studio, {rgb(0xE3D2AE), rgb(0xCDB183), rgb(0xDCCDB0), -0.045f, true});
    write_color(studio, "plaster", canvas);
    write_normal(studio, "plaster_normal", canvas, 1.2f);
    write_gloss(studio, "plaster_gloss", canvas);
}

void paint_plaster_ochre(const Studio& studio)
{
    const Canvas canvas = paint_coat(studio, {rgb(0xDDB88C), rgb(0xC6956A), rgb(0xD6B893), -0.07f, false});
    write_color(studio, "plaster_ochre", canvas);
    write_normal(studio, "plaster_ochre_normal", canvas, 1.2f);
}

void paint_whitewash(const Studio& studio)
{
    constexpr float tile = 2.4f;
    const Noise noise(studio.seed);
    Canvas canvas = paint(studio.size, tile, [&](vec2 uv) {
        const float broad = noise.fbm(uv, 2, 5), fine = noise.fbm(uv, 30, 4);
        const float brush = noise.fbm(uv + 0.05f * vec2(broad), ivec2(9, 60), 3);
        Texel t;
        t.height = 0.003f * broad + 0.0016f * fine + 0.0008f * brush;
        t.color = glm::mix(rgb(0xE9DFC9), rgb(0xCDB994), ramp(-0.1f, 0.6f, broad)) * (1 + 0.03f * fine + 0.02f * brush);
        t.color = glm::mix(t.color, rgb(0xA5937A), 0.3f * ramp(0.25f, 0.6f, noise.fbm(uv + vec2(0.5f), 3, 4)));
        return t;
    });
    weather_by_height(canvas, 0.02f, 0.5f, 0.2f);
    write_color(studio, "whitewash", canvas);
    write_normal(studio, "whitewash_normal", canvas, 1.3f);
}

} // namespace atrium::courtyard
