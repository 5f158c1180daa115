#pragma once
// A texture family while it is painted: colour, height, gloss and opacity per texel, and the images made of them.

#include "assetconv/courtyard/textures/noise.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace atrium::courtyard {

/// What a painter says of one point.
struct Texel {
    vec3 color{0.5f};   ///< sRGB-encoded, 0 to 1
    float height = 0;   ///< metres
    float gloss = 0.5f; ///< 0 to 1: the grey of map_Ks, or of map_Pr where the family is painted for that
    float alpha = 1;
};

struct Canvas {
    int size = 0;
    float metres = 1; ///< width of the tile
    std::vector<Texel> texels;
    [[nodiscard]] const Texel& at(int x, int y) const; ///< wraps
};

/// Where and how large a family is painted.
struct Studio {
    std::filesystem::path folder;
    std::uint32_t seed = 1;
    int size = 512;
};

/// Asks for every texel's colour at its middle; v runs upwards, row 0 is the top.
[[nodiscard]] Canvas paint(int size, float metres, const std::function<Texel(vec2 uv)>& painter);

/// Darkens hollows and lights edges of the colour, by the height against its neighbourhood's mean `radius` metres
/// around: stands in for dirt that gathers and for wear.
void weather_by_height(Canvas& canvas, float radius, float hollow, float edge);

void write_color(const Studio& studio, const std::string& name, const Canvas& canvas);
void write_color_alpha(const Studio& studio, const std::string& name, const Canvas& canvas);
void write_alpha(const Studio& studio, const std::string& name, const Canvas& canvas);
void write_gloss(const Studio& studio, const std::string& name, const Canvas& canvas);
/// Tangent-space normals of the height, green up; `exaggerate` scales the height. `aspect`: tile height over width.
void write_normal(const Studio& studio, const std::string& name, const Canvas& canvas, float exaggerate = 1,
                  float aspect = 1);

[[nodiscard]] inline vec3 rgb(int hex)
{
    return vec3((hex >> 16) & 255, (hex >> 8) & 255, hex & 255) / 255.0f;
}

/// Bricks, ashlar, slabs: courses of stones, each course shifted, joints between.
struct Bond {
    int courses = 6, stones = 4;
    float shift = 0.5f; ///< of every other course, in stones
    float jitter = 0;   ///< of the joints between stones, in stones
    vec2 tile{1};       ///< metres
};
struct Stone {
    std::uint32_t id = 0;
    float edge = 0; ///< metres from the nearest side
    vec2 within{0}; ///< metres from the stone's middle
    vec2 half{0};   ///< metres
};
[[nodiscard]] Stone stone_at(const Bond& bond, vec2 uv, std::uint32_t seed);

} // namespace atrium::courtyard
