#include "assetconv/block_compression.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atrium {
namespace {

constexpr std::size_t texels_in_block = 16;
using Colors = std::array<vec3, texels_in_block>;
using Values = std::array<float, texels_in_block>;

std::uint16_t to_565(const vec3& c)
{
    const auto part = [](float v, float max) {
        return static_cast<std::uint32_t>(std::clamp(v, 0.0f, 255.0f) / 255.0f * max + 0.5f);
    };
    return static_cast<std::uint16_t>(part(c.x, 31) << 11 | part(c.y, 63) << 5 | part(c.z, 31));
}

vec3 from_565(std::uint16_t c)
{
    return {static_cast<float>(c >> 11) * 255.0f / 31.0f, static_cast<float>(c >> 5 & 63) * 255.0f / 63.0f,
            static_cast<float>(c & 31) * 255.0f / 31.0f};
}

/// The direction of largest spread, by power iteration on the covariance.
vec3 principal_axis(const Colors& colors, const vec3& mean)
{
    mat3 covariance(0);
    for (const vec3& c : colors) covariance += glm::outerProduct(c - mean, c - mean);
    vec3 axis(0.299f, 0.587f, 0.114f);
    for (int i = 0; i < 8; ++i) {
        const vec3 next = covariance * axis;
        const float length = glm::length(next);
        if (length < 1e-6f) break;
        axis = next / length;
    }
    return axis;
}

struct ColorBlock {
    std::uint16_t high = 0, low = 0;
    std::array<std::uint8_t, texels_in_block> choice{}; ///< 0 high, 1 low, 2 and 3 between
    float error = 0;
};

/// The four-colour mode needs high > low as numbers.
ColorBlock fit(const Colors& colors, const vec3& a, const vec3& b)
{
    ColorBlock block{.high = to_565(a), .low = to_565(b)};
    if (block.high < block.low) std::swap(block.high, block.low);
    const vec3 high = from_565(block.high), low = from_565(block.low);
    const std::array<vec3, 4> palette{high, low, (high * 2.0f + low) / 3.0f, (high + low * 2.0f) / 3.0f};
    const std::size_t usable = block.high == block.low ? 1 : 4;
    for (std::size_t i = 0; i < texels_in_block; ++i) {
        float best = 1e30f;
        for (std::size_t k = 0; k < usable; ++k) {
            const vec3 d = colors[i] - palette[k];
            const float distance = glm::dot(d, d);
            if (distance >= best) continue;
            best = distance;
            block.choice[i] = static_cast<std::uint8_t>(k);
        }
        block.error += best;
    }
    return block;
}

/// End points that fit the choices best, in the least-squares sense.
ColorBlock refine(const Colors& colors, const ColorBlock& block)
{
    constexpr std::array<float, 4> share_of_high{1.0f, 0.0f, 2.0f / 3.0f, 1.0f / 3.0f};
    float aa = 0, ab = 0, bb = 0;
    vec3 ac(0), bc(0);
    for (std::size_t i = 0; i < texels_in_block; ++i) {
        const float a = share_of_high[block.choice[i]], b = 1 - a;
        aa += a * a;
        ab += a * b;
        bb += b * b;
        ac += a * colors[i];
        bc += b * colors[i];
    }
    const float det = aa * bb - ab * ab;
    if (std::abs(det) < 1e-4f) return block;
    const ColorBlock better = fit(colors, (ac * bb - bc * ab) / det, (bc * aa - ac * ab) / det);
    return better.error < block.error ? better : block;
}

void write_color_block(const Colors& colors, std::vector<std::uint8_t>& out)
{
    vec3 mean(0);
    for (const vec3& c : colors) mean += c / 16.0f;
    const vec3 axis = principal_axis(colors, mean);
    float low = 1e30f, high = -1e30f;
    for (const vec3& c : colors) {
        low = std::min(low, glm::dot(c - mean, axis));
        high = std::max(high, glm::dot(c - mean, axis));
    }
    const ColorBlock block = refine(colors, fit(colors, mean + axis * high, mean + axis * low));
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < texels_in_block; ++i) bits |= std::uint32_t{block.choice[i]} << (2 * i);
    for (const std::uint16_t c : {block.high, block.low}) {
        out.push_back(static_cast<std::uint8_t>(c & 255));
        out.push_back(static_cast<std::uint8_t>(c >> 8));
    }
    for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>(bits >> (8 * i) & 255));
}

/// One channel between its extremes in eight steps (BC4; the alpha of BC3, each half of BC5).
void write_value_block(const Values& values, std::vector<std::uint8_t>& out)
{
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const auto a0 = static_cast<std::uint8_t>(*high), a1 = static_cast<std::uint8_t>(*low);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < texels_in_block && a0 > a1; ++i) {
        const float t = (static_cast<float>(a0) - values[i]) / static_cast<float>(a0 - a1); // 0 at a0, 1 at a1
        const auto step = static_cast<std::uint64_t>(t * 7 + 0.5f);
        const std::uint64_t code = step == 0 ? 0 : step == 7 ? 1 : step + 1;
        bits |= code << (3 * i);
    }
    out.push_back(a0);
    out.push_back(a1);
    for (int i = 0; i < 6; ++i) out.push_back(static_cast<std::uint8_t>(bits >> (8 * i) & 255));
}

} // namespace

std::vector<std::uint8_t> compress_level(const MipLevel& level, TextureFormat format)
{
    const std::uint32_t channels = format == TextureFormat::bc5_unorm ? 2 : 4;
    std::vector<std::uint8_t> out;
    for (std::uint32_t by = 0; by < level.height; by += 4) {
        for (std::uint32_t bx = 0; bx < level.width; bx += 4) {
            Colors colors{};
            std::array<Values, 4> values{};
            for (std::uint32_t i = 0; i < texels_in_block; ++i) {
                const std::uint32_t x = std::min(bx + i % 4, level.width - 1),
                                    y = std::min(by + i / 4, level.height - 1);
                const std::uint8_t* t = &level.texels[(std::size_t{y} * level.width + x) * channels];
                for (std::uint32_t k = 0; k < channels; ++k) values[k][i] = t[k];
                if (channels == 4) colors[i] = vec3(t[0], t[1], t[2]);
            }
            if (format == TextureFormat::bc5_unorm) {
                write_value_block(values[0], out);
                write_value_block(values[1], out);
                continue;
            }
            if (format != TextureFormat::bc1_srgb) write_value_block(values[3], out);
            write_color_block(colors, out);
        }
    }
    return out;
}

} // namespace atrium
