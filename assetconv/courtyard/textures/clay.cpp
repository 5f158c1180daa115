// Fired clay: vessels and roof tiles.
#include "assetconv/courtyard/textures/textures.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {

void paint_terracotta(const Studio& studio)
{
    constexpr float tile = 0.9f;
    const Noise noise(studio.seed);
    Canvas canvas = paint(studio.size, tile, [&](vec2 uv) {
        const float rings = noise.fbm(uv, ivec2(1, 60), 3), cloud = noise.fbm(uv, 3, 5), grain = noise.fbm(uv, 50, 3);
        const float bloom =
            ramp(0.05f, 0.55f, noise.fbm(uv + vec2(0.3f, 0.1f), 4, 5)); // lime that the water brought out
        const float green = ramp(0.2f, 0.6f, noise.fbm(uv + vec2(0.7f, 0.6f), 5, 4));
        Texel t;
        t.color = glm::mix(rgb(0xB5623C), rgb(0xCB8356), 0.5f + 0.7f * cloud) * (1 + 0.06f * rings + 0.06f * grain);
        t.color = glm::mix(t.color, rgb(0xD8BFA2), 0.4f * bloom);
        t.color = glm::mix(t.color, rgb(0x70693F), 0.35f * green);
        t.height = 0.0012f * rings + 0.0008f * grain;
        return t;
    });
    write_color(studio, "terracotta", canvas);
    write_normal(studio, "terracotta_normal", canvas);
}

void paint_roof_tile(const Studio& studio)
{
    constexpr float tile = 1.6f;
    constexpr int columns = 7, rows = 4;
    const Noise noise(studio.seed);
    Canvas canvas = paint(studio.size, tile, [&](vec2 uv) {
        const vec2 p = uv * vec2(columns, rows);
        const ivec2 cell = glm::min(ivec2(p), ivec2(columns - 1, rows - 1));
        const vec2 within = p - vec2(cell);
        const float tone = noise.cell(cell.x, cell.y), hue = noise.cell(cell.x + 31, cell.y);
        const float cloud = noise.fbm(uv, 5, 4), grain = noise.fbm(uv, 60, 3);
        Texel t;
        t.color = glm::mix(glm::mix(rgb(0xB05F3B), rgb(0xCD8557), tone), rgb(0xC9A078), 0.5f * hue * hue);
        if (hue < 0.12f) {
            t.color = rgb(0x8C4E38);
        }
        t.color *= 0.95f + 0.12f * cloud + 0.1f * grain;
        const float overlap = ramp(0.82f, 1.0f, within.y); // in the shade of the tile above
        t.color *= 1 - 0.35f * overlap;
        t.color = glm::mix(t.color, rgb(0x6B4A38), 0.4f * ramp(0.06f, 0.0f, within.y));
        const float lichen = ramp(0.3f, 0.12f, noise.worley(uv, ivec2(22)).nearest) * ramp(0.1f, 0.4f, cloud);
        t.color = glm::mix(t.color, rgb(0xC7BC93), 0.6f * lichen);
        const float green = ramp(0.1f, 0.5f, noise.fbm(uv + vec2(0.2f), 4, 4));
        t.color = glm::mix(t.color, rgb(0x6D6B40), 0.35f * green);
        t.height = 0.0015f * grain + 0.001f * lichen - 0.006f * ramp(0.03f, 0.0f, within.y);
        return t;
    });
    write_color(studio, "roof_tile", canvas);
    write_normal(studio, "roof_tile_normal", canvas);
}

} // namespace atrium::courtyard
