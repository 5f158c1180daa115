#include "assetconv/courtyard/textures/noise.hpp"

#include <cmath>

namespace atrium::courtyard {
namespace {

int wrap(int x, int period)
{
    const int r = x % period;
    return r < 0 ? r + period : r;
}

float fade(float t)
{
    return t * t * t * (t * (t * 6 - 15) + 10);
}

/// One of eight directions, dotted with the offset.
float slope(std::uint32_t h, float x, float y)
{
    constexpr float d = 0.70710678f;
    switch (h >> 29) {
    case 0:
        return x;
    case 1:
        return -x;
    case 2:
        return y;
    case 3:
        return -y;
    case 4:
        return d * (x + y);
    case 5:
        return d * (x - y);
    case 6:
        return d * (y - x);
    default:
        return -d * (x + y);
    }
}

} // namespace

float Noise::gradient(vec2 uv, ivec2 frequency) const
{
    const vec2 p = uv * vec2(frequency);
    const vec2 floor = glm::floor(p), f = p - floor;
    const int x0 = wrap(static_cast<int>(floor.x), frequency.x), y0 = wrap(static_cast<int>(floor.y), frequency.y);
    const int x1 = x0 + 1 == frequency.x ? 0 : x0 + 1, y1 = y0 + 1 == frequency.y ? 0 : y0 + 1;
    const std::uint32_t salt = static_cast<std::uint32_t>(frequency.x) * 7919u;
    const float a = slope(hash(x0, y0, salt), f.x, f.y), b = slope(hash(x1, y0, salt), f.x - 1, f.y);
    const float c = slope(hash(x0, y1, salt), f.x, f.y - 1), d = slope(hash(x1, y1, salt), f.x - 1, f.y - 1);
    const float s = fade(f.x), t = fade(f.y);
    return 1.5f * glm::mix(glm::mix(a, b, s), glm::mix(c, d, s), t);
}

float Noise::fbm(vec2 uv, ivec2 frequency, int octaves) const
{
    float sum = 0, weight = 0.5f;
    for (int i = 0; i < octaves; ++i, frequency *= 2, weight *= 0.5f) {
        sum += weight * gradient(uv, frequency);
    }
    return sum * 1.3f;
}

float Noise::ridged(vec2 uv, ivec2 frequency, int octaves) const
{
    float sum = 0, weight = 0.5f;
    for (int i = 0; i < octaves; ++i, frequency *= 2, weight *= 0.5f) {
        sum += weight * std::abs(gradient(uv, frequency));
    }
    return sum * 1.6f;
}

Noise::Cell Noise::worley(vec2 uv, ivec2 frequency) const
{
    const vec2 p = uv * vec2(frequency);
    const vec2 floor = glm::floor(p);
    Cell cell{9, 9, 0, vec2(0)};
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            const int x = static_cast<int>(floor.x) + i, y = static_cast<int>(floor.y) + j;
            const std::uint32_t h = hash(wrap(x, frequency.x), wrap(y, frequency.y), 0x51u);
            const vec2 point(static_cast<float>(x) + unit(h), static_cast<float>(y) + unit(mix(h, 7)));
            const vec2 offset = p - point;
            const float d = glm::length(offset);
            if (d < cell.nearest) {
                cell.second = cell.nearest;
                cell.nearest = d;
                cell.id = h;
                cell.offset = offset;
            } else if (d < cell.second) {
                cell.second = d;
            }
        }
    }
    return cell;
}

} // namespace atrium::courtyard
