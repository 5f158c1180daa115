// The court's slabs in two stones, and the aisles' octagons with dots.
#include "assetconv/courtyard/textures/textures.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {

void paint_floor_court(const Studio& studio)
{
    constexpr float tile = 2.4f;
    constexpr int slabs = 4;
    const Noise noise(studio.seed);
    const Bond bond{.courses = slabs, .stones = slabs, .shift = 0, .jitter = 0, .tile = vec2(tile)};
    Canvas canvas = paint(studio.size, tile, [&](vec2 uv) {
        const Stone slab = stone_at(bond, uv, studio.seed);
        const ivec2 at = ivec2(uv * static_cast<float>(slabs));
        const bool light = (at.x + at.y) % 2 == 0;
        const float tone = unit(slab.id);
        const vec2 own =
            uv + vec2(unit(mix(slab.id, 1)), unit(mix(slab.id, 2))); // each slab from another place of the quarry
        const float cloud = noise.fbm(own, 4, 5), grain = noise.fbm(uv, 60, 3);
        const float vein = ramp(0.1f, 0.0f, noise.ridged(own + 0.04f * vec2(cloud), ivec2(3), 4));
        const float chip = std::max(0.0f, noise.fbm(uv, 17, 3) - 0.2f) * 0.045f;
        const float edge = slab.edge - chip + 0.002f * noise.fbm(uv, 40, 2);
        const float body = ramp(0.003f, 0.013f, edge);
        Texel t;
        const vec3 stone = light ? glm::mix(rgb(0xCFBF9F), rgb(0xE0D3B6), 0.5f + cloud)
                                 : glm::mix(rgb(0x9A6650), rgb(0xB58368), 0.5f + cloud);
        vec3 face = stone * (0.93f + 0.13f * tone + 0.05f * grain);
        face = glm::mix(face, light ? rgb(0xA78F6C) : rgb(0xD3B79A), (light ? 0.35f : 0.4f) * vein);
        const float dirt = ramp(0.0f, 0.5f, noise.fbm(uv, 3, 5));
        face = glm::mix(face, rgb(0x7C6D56), 0.3f * dirt);
        t.color = glm::mix(rgb(0x6A5E4B), face, body);
        const float green =
            ramp(0.05f, 0.4f, noise.fbm(uv + vec2(0.4f, 0.2f), 3, 4)) * ramp(0.025f, 0.0f, edge + 0.01f * grain);
        t.color = glm::mix(t.color, rgb(0x676F3C), 0.7f * green);
        const vec2 tilt(unit(mix(slab.id, 3)) - 0.5f, unit(mix(slab.id, 4)) - 0.5f);
        t.height = body * (0.008f + 0.008f * glm::dot(tilt, slab.within)) + 0.0008f * grain - 0.0007f * vein +
                   0.0015f * cloud * body;
        t.gloss = 0.3f + 0.45f * body - 0.35f * dirt + 0.1f * grain;
        return t;
    });
    weather_by_height(canvas, 0.012f, 0.55f, 0.25f);
    write_color(studio, "floor_court", canvas);
    write_normal(studio, "floor_court_normal", canvas, 1.1f);
    write_gloss(studio, "floor_court_gloss", canvas);
}

void paint_floor_aisle(const Studio& studio)
{
    constexpr float tile = 1.2f, pitch = 0.3f, dot = 0.062f; // dot: half diagonal of the small squares at the corners
    const Noise noise(studio.seed);
    Canvas canvas = paint(studio.size, tile, [&](vec2 uv) {
        const vec2 p = uv * (tile / pitch);
        const vec2 middle = (glm::fract(p) - 0.5f) * pitch; // from the octagon's middle
        const vec2 to_corner = vec2(0.5f * pitch) - glm::abs(middle);
        const float diagonal = (to_corner.x + to_corner.y - dot) * 0.7071f; // beyond it lies the dot
        const bool octagon = diagonal > 0;
        const ivec2 cell = octagon ? ivec2(p) : ivec2(glm::floor(p + 0.5f)) % 4;
        const float edge = octagon ? std::min({to_corner.x, to_corner.y, diagonal}) : -diagonal;
        const float tone = noise.cell(cell.x + (octagon ? 0 : 50), cell.y);
        const float cloud = noise.fbm(uv, 6, 4), grain = noise.fbm(uv, 50, 3);
        const float body = ramp(0.0015f, 0.006f, edge + 0.001f * grain);
        Texel t;
        vec3 face =
            octagon ? glm::mix(rgb(0xA9603F), rgb(0xC98A5E), tone) : glm::mix(rgb(0x3F5A5E), rgb(0x55716B), tone);
        face *= 0.96f + 0.09f * grain + 0.1f * cloud;
        const float worn = ramp(-0.05f, 0.5f, noise.fbm(uv, 3, 4));
        face = glm::mix(face, rgb(0xC9A98A), octagon ? 0.22f * worn : 0.1f * worn);
        t.color = glm::mix(rgb(0x9C8B72), face, body);
        t.height = body * (0.004f + 0.0012f * tone) + 0.0005f * grain;
        t.gloss = 0.25f + (octagon ? 0.3f : 0.55f) * body + 0.1f * grain - 0.15f * worn;
        return t;
    });
    weather_by_height(canvas, 0.006f, 0.5f, 0.2f);
    write_color(studio, "floor_aisle", canvas);
    write_normal(studio, "floor_aisle_normal", canvas);
    write_gloss(studio, "floor_aisle_gloss", canvas);
}

} // namespace atrium::courtyard
