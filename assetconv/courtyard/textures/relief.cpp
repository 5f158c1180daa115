// A lion's head, carved: heights put together from rounded bumps.
#include "assetconv/courtyard/textures/textures.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {
namespace {

/// A rounded bump: 1 in the middle, 0 at the ellipse's edge.
float bump(vec2 p, vec2 middle, vec2 radii, float sharpness = 1)
{
    const vec2 q = (p - middle) / radii;
    const float inside = 1 - glm::dot(q, q);
    return inside <= 0 ? 0 : std::pow(inside, sharpness);
}

/// The same on both sides of the face.
float pair(vec2 p, vec2 middle, vec2 radii, float sharpness = 1)
{
    return bump({std::abs(p.x), p.y}, middle, radii, sharpness);
}

/// Curls of the mane: two rings of locks, each a ridge that bends.
float mane(vec2 p)
{
    const float r = glm::length(p * vec2(1, 0.95f)), a = std::atan2(p.x, p.y);
    float h = 0;
    for (int ring = 0; ring < 2; ++ring) {
        const float count = ring == 0 ? 17.0f : 13.0f, outer = ring == 0 ? 0.95f : 0.76f,
                    inner = ring == 0 ? 0.6f : 0.42f;
        const float bend = 1.6f * (r - inner) * (p.x < 0 ? -1.0f : 1.0f);
        const float lock = std::abs(std::sin(0.5f * count * (a + bend) + 0.8f * static_cast<float>(ring)));
        const float tip = outer - 0.09f * (1 - lock);
        const float body = ramp(tip, tip - 0.1f, r) * ramp(inner - 0.12f, inner + 0.05f, r);
        const float strands = 0.02f * std::sin(3 * count * (a + bend) + 9 * r);
        h = std::max(h, body * ((ring == 0 ? 0.16f : 0.25f) + 0.13f * std::sqrt(lock) + strands));
    }
    return h;
}

float lion(vec2 p)
{
    float h = mane(p);
    const float face = 0.42f * bump(p, {0, -0.04f}, {0.46f, 0.56f}, 0.6f);
    h = std::max(h, face);
    const float on_face = ramp(0.0f, 0.12f, face);
    h += on_face * 0.1f * pair(p, {0.19f, 0.23f}, {0.19f, 0.1f});        // brows
    h += on_face * 0.05f * bump(p, {0, 0.34f}, {0.13f, 0.16f});          // forehead
    h += on_face * 0.16f * bump(p, {0, 0.0f}, {0.1f, 0.36f}, 0.7f);      // bridge of the nose
    h += on_face * 0.13f * bump(p, {0, -0.22f}, {0.15f, 0.09f}, 0.6f);   // its tip
    h -= on_face * 0.1f * pair(p, {0.2f, 0.09f}, {0.13f, 0.085f}, 0.7f); // sockets
    h += on_face * 0.09f * pair(p, {0.2f, 0.09f}, {0.075f, 0.05f}, 0.6f);
    h -= on_face * 0.05f * pair(p, {0.2f, 0.09f}, {0.025f, 0.025f});
    h += on_face * 0.15f * pair(p, {0.12f, -0.33f}, {0.18f, 0.14f}, 0.6f); // muzzle
    h += on_face * 0.07f * pair(p, {0.31f, -0.12f}, {0.14f, 0.22f});       // cheeks
    h -= on_face * 0.13f * bump(p, {0, -0.445f}, {0.2f, 0.035f}, 0.6f);    // mouth
    h -= 0.05f * bump(p, {0, -0.33f}, {0.014f, 0.12f});                    // the line below the nose
    h += 0.12f * bump(p, {0, -0.53f}, {0.13f, 0.085f}, 0.6f);              // chin
    const float nostril = pair(p, {0.075f, -0.245f}, {0.04f, 0.025f});
    h -= 0.07f * nostril;
    for (int i = 0; i < 3; ++i) { // where the whiskers grow
        h -= 0.025f *
             pair(p, {0.1f + 0.06f * static_cast<float>(i), -0.33f - 0.02f * static_cast<float>(i)}, {0.016f, 0.016f});
    }
    const float ear = pair(p, {0.4f, 0.42f}, {0.14f, 0.13f}, 0.6f);
    h = std::max(h, 0.42f * ear) - 0.16f * pair(p, {0.39f, 0.42f}, {0.08f, 0.075f});
    return h;
}

} // namespace

void paint_relief(const Studio& studio)
{
    const Noise noise(studio.seed);
    Canvas canvas = paint(studio.size, 1, [&](vec2 uv) {
        const vec2 p = 2.0f * uv - 1.0f;
        const float grain = noise.fbm(uv, 40, 4), broad = noise.fbm(uv, 3, 4);
        Texel t;
        t.height = 0.17f * lion(p * 1.06f) + 0.0022f * grain;
        t.color = glm::mix(rgb(0xDCCBA8), rgb(0xC7B08A), 0.5f + 0.7f * broad) * (1 + 0.05f * grain);
        const float streak = ramp(0.1f, 0.7f, noise.fbm(uv, ivec2(24, 2), 3)) * ramp(1.0f, 0.1f, uv.y);
        t.color = glm::mix(t.color, rgb(0x857455), 0.35f * streak);
        t.gloss = 0.45f + 0.15f * grain - 0.3f * streak;
        return t;
    });
    weather_by_height(canvas, 0.03f, 0.9f, 0.35f);
    write_color(studio, "relief", canvas);
    write_normal(studio, "relief_normal", canvas);
    write_gloss(studio, "relief_gloss", canvas);
}

} // namespace atrium::courtyard
