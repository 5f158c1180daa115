#pragma once
// Small pictures of known error. The known values of FLIP are those of its authors' own program, version 1.6.

#include "renderer/core/image.hpp"
#include "renderer/metrics/flip.hpp"

#include <array>
#include <functional>

namespace atrium {

using Bytes = std::array<int, 3>;

/// Encoded values in 0 to 1, from bytes.
inline ImageF picture(int width, int height, const std::function<Bytes(int, int)>& bytes)
{
    ImageF out(width, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Bytes b = bytes(x, y);
            for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = static_cast<float>(b[c]) / 255.0f;
        }
    }
    return out;
}

inline ImageF uniform(const Bytes& color)
{
    return picture(16, 16, [&](int, int) { return color; });
}

struct KnownPair {
    const char* name;
    ImageF reference, test;
    double flip, flip_max, mse, psnr, ssim;
};

inline std::vector<KnownPair> known_pairs()
{
    const Bytes black{0, 0, 0}, white{255, 255, 255};
    const auto dot = [=](int x, int y) { return x == 16 && y == 16 ? white : black; };
    const auto from_column = [=](int first) { return [=](int x, int) { return x >= first ? white : black; }; };
    const auto ramp = [](int more) {
        return [=](int x, int y) { return Bytes{std::min(255, 8 * x + more), 8 * y, (x * y) % 256}; };
    };
    return {
        {"greys", uniform({128, 128, 128}), uniform({140, 140, 140}), 0.169142, 0.169142, 0.002215, 26.5472, 0.995999},
        {"black and white", uniform(black), uniform(white), 0.967391, 0.967388, 1, 0, 0.000100},
        {"red and green", uniform({255, 0, 0}), uniform({0, 255, 0}), 0.986664, 0.986665, 0.666667, 1.7609, 0.546332},
        {"green and blue", uniform({0, 255, 0}), uniform({0, 0, 255}), 1, 1, 0.666667, 1.7609, 0.200020},
        {"browns", uniform({200, 100, 50}), uniform({190, 110, 60}), 0.197824, 0.197824, 0.001538, 28.1308, 0.998864},
        {"a dot", picture(33, 33, [=](int, int) { return black; }), picture(33, 33, dot), 0.013140, 0.864906, 0.000918,
         30.3703, 0.880939},
        {"an edge", picture(32, 32, from_column(16)), picture(32, 32, from_column(17)), 0.103463, 0.772917, 0.031250,
         15.0515, 0.679219},
        {"a ramp", picture(32, 32, ramp(0)), picture(32, 32, ramp(6)), 0.085638, 0.145416, 0.000185, 37.3390, 0.999923},
    };
}

inline ImageF decoded(ImageF image)
{
    for (float& value : image.values) value = static_cast<float>(linear_from_srgb(value));
    return image;
}

} // namespace atrium
