#include "assetconv/mips.hpp"

#include "assetconv/srgb.hpp"

#include <algorithm>
#include <cmath>
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

/// The alpha channel of an RGBA image.
template <class Value>
MaskLevel<Value> alpha_of(int width, int height, std::span<const Value> texels)
{
    MaskLevel<Value> out{width, height, std::vector<Value>(texels.size() / 4)};
    for (std::size_t i = 0; i < out.alpha.size(); ++i) out.alpha[i] = texels[i * 4 + 3];
    return out;
}

/// Writes the alpha of a mask's levels.
class MaskFitter {
public:
    MaskFitter(const PackedImage& image, const FloatLevel& finest, const MaskTest& test)
        : test_(test), wanted_(covered_area(alpha_of<std::uint8_t>(image.width, image.height, image.texels), test)),
          deviation_(deviation_of(alpha_of<float>(finest.width, finest.height, finest.values).alpha))
    {}

    /// Fits the alpha of `out`, the level after `before`. False if the mask is too flat at this size.
    bool fit(const FloatLevel& level, const MipLevel* before, MipLevel& out) const
    {
        const auto fitted =
            fit_mask(alpha_of<float>(level.width, level.height, level.values), test_, wanted_, deviation_);
        if (!fitted) return false;
        for (std::size_t i = 0; i < fitted->alpha.size(); ++i) out.texels[i * 4 + 3] = fitted->alpha[i];
        if (before == nullptr) return true;
        const auto width = static_cast<int>(before->width), height = static_cast<int>(before->height);
        return mix_well(alpha_of<std::uint8_t>(width, height, before->texels), *fitted, test_, wanted_);
    }

private:
    MaskTest test_;
    double wanted_, deviation_;
};

} // namespace

std::vector<MipLevel> build_mips(const PackedImage& image, MipSpace space, const std::optional<MaskTest>& mask,
                                 std::uint32_t max_size)
{
    const auto fits = [&](const FloatLevel& l) {
        return static_cast<std::uint32_t>(std::max(l.width, l.height)) <= max_size;
    };
    std::vector<MipLevel> levels;
    FloatLevel level = decode(image, space);
    std::optional<MaskFitter> fitter;
    if (mask) fitter.emplace(image, level, *mask);
    if (fits(level) || (level.width == 1 && level.height == 1))
        levels.push_back(
            {static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height), image.texels});
    while (level.width > 1 || level.height > 1) {
        level = halve(level);
        if (!fits(level) && (level.width > 1 || level.height > 1)) continue;
        MipLevel encoded = encode(level, space);
        const MipLevel* before = levels.empty() ? nullptr : &levels.back();
        if (fitter && !fitter->fit(level, before, encoded) && before != nullptr) break;
        levels.push_back(std::move(encoded));
    }
    return levels;
}

} // namespace atrium
