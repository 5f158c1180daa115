#include "assetconv/mips.hpp"

#include "assetconv/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace atrium {
namespace {

/// Texels as numbers that may be averaged; normals stay unnormalised so that longer averages weigh more.
struct FloatLevel {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;
};

vec3 decode_normal(const std::uint8_t* texel)
{
    const float x = static_cast<float>(texel[0]) / 127.5f - 1, y = static_cast<float>(texel[1]) / 127.5f - 1;
    return {x, y, std::sqrt(std::max(0.0f, 1 - x * x - y * y))};
}

FloatLevel decode(const PackedImage& image, MipSpace space)
{
    const std::array<float, 256>& linear = srgb_decode_table();
    FloatLevel level{image.width, image.height, space == MipSpace::normals ? 3 : image.channels, {}};
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    level.values.reserve(count * static_cast<std::size_t>(level.channels));
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* t = &image.texels[i * static_cast<std::size_t>(image.channels)];
        if (space == MipSpace::normals) {
            const vec3 n = decode_normal(t);
            level.values.insert(level.values.end(), {n.x, n.y, n.z});
            continue;
        }
        for (int k = 0; k < image.channels; ++k) {
            const bool encoded = space == MipSpace::srgb_color && k < 3;
            level.values.push_back(encoded ? linear[t[k]] : static_cast<float>(t[k]) / 255.0f);
        }
    }
    return level;
}

/// The texels under one coarser texel along one axis, and their shares.
struct Taps {
    int first = 0, count = 0;
    float weights[4] = {};
};

std::vector<Taps> taps_along(int fine, int coarse)
{
    std::vector<Taps> all(static_cast<std::size_t>(coarse));
    const double ratio = static_cast<double>(fine) / coarse;
    for (int i = 0; i < coarse; ++i) {
        const double from = i * ratio, to = (i + 1) * ratio;
        Taps& t = all[static_cast<std::size_t>(i)];
        t.first = static_cast<int>(from + 1e-9);
        for (int k = t.first; k < fine && k < to - 1e-9; ++k) {
            t.weights[t.count++] =
                static_cast<float>((std::min<double>(k + 1, to) - std::max<double>(k, from)) / ratio);
        }
    }
    return all;
}

FloatLevel halve(const FloatLevel& fine)
{
    FloatLevel coarse{std::max(1, fine.width / 2), std::max(1, fine.height / 2), fine.channels, {}};
    const std::vector<Taps> across = taps_along(fine.width, coarse.width),
                            down = taps_along(fine.height, coarse.height);
    const auto channels = static_cast<std::size_t>(fine.channels);
    coarse.values.assign(static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height) * channels,
                         0.0f);
    float* out = coarse.values.data();
    for (const Taps& ty : down) {
        for (const Taps& tx : across) {
            for (int j = 0; j < ty.count; ++j) {
                const std::size_t row = static_cast<std::size_t>(ty.first + j) * static_cast<std::size_t>(fine.width);
                const float* in = &fine.values[(row + static_cast<std::size_t>(tx.first)) * channels];
                for (int i = 0; i < tx.count; ++i) {
                    const float weight = ty.weights[j] * tx.weights[i];
                    for (std::size_t k = 0; k < channels; ++k) out[k] += *in++ * weight;
                }
            }
            out += channels;
        }
    }
    return coarse;
}

std::uint8_t to_byte(float x)
{
    return static_cast<std::uint8_t>(std::clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f);
}

MipLevel encode(const FloatLevel& level, MipSpace space)
{
    MipLevel out{static_cast<std::uint32_t>(level.width), static_cast<std::uint32_t>(level.height), {}};
    const auto channels = static_cast<std::size_t>(level.channels);
    out.texels.reserve(level.values.size());
    for (std::size_t i = 0; i < level.values.size(); i += channels) {
        const float* v = &level.values[i];
        if (space == MipSpace::normals) {
            const vec3 n(v[0], v[1], v[2]);
            const float length = glm::length(n);
            const vec3 unit = length > 1e-4f ? n / length : vec3(0, 0, 1);
            out.texels.push_back(to_byte(unit.x * 0.5f + 0.5f));
            out.texels.push_back(to_byte(unit.y * 0.5f + 0.5f));
            continue;
        }
        for (std::size_t k = 0; k < channels; ++k) {
            out.texels.push_back(space == MipSpace::srgb_color && k < 3 ? srgb_encode8(v[k]) : to_byte(v[k]));
        }
    }
    return out;
}

/// Mean alpha of the texel and its neighbours: which of two equal texels belongs to the denser part of the mask.
float density(const FloatLevel& level, std::size_t texel)
{
    const int x = static_cast<int>(texel) % level.width, y = static_cast<int>(texel) / level.width;
    float sum = 0;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            const int u = (x + i + level.width) % level.width, v = (y + j + level.height) % level.height;
            sum += level.values[(static_cast<std::size_t>(v) * static_cast<std::size_t>(level.width) +
                                 static_cast<std::size_t>(u)) *
                                    4 +
                                3];
        }
    }
    return sum;
}

/// Writes alpha so that `wanted` texels, the densest, come out at or above mask_code and all others below.
void keep_coverage_of(const FloatLevel& level, MipLevel& out, std::size_t wanted)
{
    const std::size_t count = level.values.size() / 4;
    const auto alpha = [&](std::size_t i) { return level.values[i * 4 + 3]; };
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    const auto denser = [&](std::uint32_t a, std::uint32_t b) {
        return alpha(a) != alpha(b) ? alpha(a) > alpha(b) : a < b;
    };
    std::sort(order.begin(), order.end(), denser);
    const float threshold = wanted == 0 ? alpha(order[0]) * 1.01f : alpha(order[wanted - 1]);
    const auto tie_begin =
        std::find_if(order.begin(), order.end(), [&](std::uint32_t i) { return alpha(i) <= threshold; });
    const auto tie_end = std::find_if(tie_begin, order.end(), [&](std::uint32_t i) { return alpha(i) < threshold; });
    std::vector<std::pair<float, std::uint32_t>> tie;
    for (auto at = tie_begin; at != tie_end; ++at) tie.emplace_back(-density(level, *at), *at);
    std::sort(tie.begin(), tie.end());
    std::transform(tie.begin(), tie.end(), tie_begin, [](const auto& t) { return t.second; });

    const float scale = mask_cutoff / std::max(threshold, 1e-3f);
    for (std::size_t i = 0; i < count; ++i) {
        const int code = to_byte(alpha(order[i]) * scale);
        const int kept = i < wanted ? std::max(code, mask_code) : std::min(code, mask_code - 1);
        out.texels[order[i] * std::size_t{4} + 3] = static_cast<std::uint8_t>(kept);
    }
}

} // namespace

double mask_coverage(std::span<const std::uint8_t> rgba)
{
    std::size_t visible = 0;
    for (std::size_t i = 3; i < rgba.size(); i += 4) visible += rgba[i] >= mask_code ? 1 : 0;
    return static_cast<double>(visible) / static_cast<double>(std::max<std::size_t>(rgba.size() / 4, 1));
}

std::vector<MipLevel> build_mips(const PackedImage& image, MipSpace space, bool keep_coverage, std::uint32_t max_size)
{
    const auto fits = [&](const FloatLevel& l) {
        return static_cast<std::uint32_t>(std::max(l.width, l.height)) <= max_size;
    };
    const double coverage = keep_coverage ? mask_coverage(image.texels) : 0;
    std::vector<MipLevel> levels;
    FloatLevel level = decode(image, space);
    if (fits(level) || (level.width == 1 && level.height == 1))
        levels.push_back(
            {static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height), image.texels});
    while (level.width > 1 || level.height > 1) {
        level = halve(level);
        if (!fits(level) && (level.width > 1 || level.height > 1)) continue;
        levels.push_back(encode(level, space));
        if (!keep_coverage) continue;
        const auto count = static_cast<double>(level.values.size() / 4);
        keep_coverage_of(level, levels.back(), static_cast<std::size_t>(coverage * count + 0.5));
    }
    return levels;
}

} // namespace atrium
