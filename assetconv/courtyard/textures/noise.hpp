#pragma once
// Noise that tiles: every function repeats with period 1 in u and v.

#include "assetconv/courtyard/random.hpp"

namespace atrium::courtyard {

class Noise {
public:
    explicit Noise(std::uint32_t seed) : seed_(seed) {}

    /// Gradient noise with `frequency` cells across the tile; about -1 to 1, mean 0. Source: Perlin 2002, "Improving
    /// Noise".
    [[nodiscard]] float gradient(vec2 uv, ivec2 frequency) const;
    /// Octaves of gradient noise, each twice as fine and half as strong; about -1 to 1.
    [[nodiscard]] float fbm(vec2 uv, ivec2 frequency, int octaves) const;
    [[nodiscard]] float fbm(vec2 uv, int frequency, int octaves) const { return fbm(uv, ivec2(frequency), octaves); }
    /// Sum of folded octaves, 0 to about 1: veins and wrinkles along its zeros.
    [[nodiscard]] float ridged(vec2 uv, ivec2 frequency, int octaves) const;

    /// Distances to the two nearest feature points, in cells, and who the nearest is. Source: Worley 1996.
    struct Cell {
        float nearest, second;
        std::uint32_t id;
        vec2 offset; ///< from the nearest point, in cells
    };
    [[nodiscard]] Cell worley(vec2 uv, ivec2 frequency) const;

    /// White noise of a cell, 0 to 1.
    [[nodiscard]] float cell(int x, int y) const
    {
        return unit(mix(mix(seed_, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y)));
    }

private:
    [[nodiscard]] std::uint32_t hash(int x, int y, std::uint32_t salt) const
    {
        return mix(mix(seed_ + salt, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y));
    }
    std::uint32_t seed_;
};

/// Hermite step from 0 at `low` to 1 at `high`; works downwards too.
[[nodiscard]] inline float ramp(float low, float high, float x)
{
    const float t = glm::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

} // namespace atrium::courtyard
