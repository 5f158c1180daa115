#include "assetconv/mask_mips.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atrium {
namespace {

/// More contrast than this would show the rounding of averages instead of the mask.
constexpr double largest_contrast = 256;
constexpr int search_steps = 14;

/// Three-point Gauss-Legendre quadrature on [0, 1]: points and weights.
constexpr std::array<double, 3> gauss_points{0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array<double, 3> gauss_weights{5.0 / 18, 8.0 / 18, 5.0 / 18};

/// Alpha less the cutoff at the corners of the cell between four texel centres.
struct Cell {
    double top_left, top_right, low_left, low_right;
};

/// Position of the zero crossing on a side of the cell; greater than 1 if there is none.
double crossing(double from, double to)
{
    return (from >= 0) != (to >= 0) ? from / (from - to) : 2.0;
}

/// Share of a cell where its bilinear patch is not below zero. Between the heights where the left and the right side
/// cross zero, the solid part of a row is a smooth function of its height.
double covered_share(const Cell& c)
{
    std::array<double, 4> cuts{0, crossing(c.top_left, c.low_left), crossing(c.top_right, c.low_right), 1};
    if (cuts[1] > cuts[2]) std::swap(cuts[1], cuts[2]);
    double covered = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double from = std::min(cuts[i], 1.0), height = std::min(cuts[i + 1], 1.0) - from;
        if (height <= 0) continue;
        for (std::size_t k = 0; k < gauss_points.size(); ++k) {
            const double y = from + height * gauss_points[k];
            const double left = std::lerp(c.top_left, c.low_left, y), right = std::lerp(c.top_right, c.low_right, y);
            const double solid = (left >= 0) == (right >= 0) ? (left >= 0 ? 1 : 0)
                                 : left >= 0                 ? left / (left - right)
                                                             : right / (right - left);
            covered += height * gauss_weights[k] * solid;
        }
    }
    return covered;
}

/// Texels and the cells between their centres along an axis. With a clamped sampler the outermost cells are half as
/// wide and reach to the edge.
struct Axis {
    int size;
    bool clamp;

    [[nodiscard]] int first() const { return clamp ? -1 : 0; }
    /// From -1 to size.
    [[nodiscard]] int texel(int i) const { return clamp ? std::clamp(i, 0, size - 1) : i < 0 ? size - 1 : i % size; }
    [[nodiscard]] double width(int cell) const { return clamp && (cell < 0 || cell == size - 1) ? 0.5 : 1; }
};

/// The two texels around a point and its distance from the first. `at`: position along the axis, 2^32 for all of it.
struct Between {
    int first, second;
    float share;
};
Between between(const Axis& axis, std::uint32_t at)
{
    constexpr std::int64_t texel = std::int64_t{1} << 32;
    const std::int64_t place = static_cast<std::int64_t>(at) * axis.size - texel / 2;
    const auto first = static_cast<int>(place >> 32);
    return {axis.texel(first), axis.texel(first + 1),
            static_cast<float>(place & (texel - 1)) / static_cast<float>(texel)};
}

/// Bilinear, 0 to 255.
float sample(const MaskLevel<std::uint8_t>& level, bool clamp, std::uint32_t u, std::uint32_t v)
{
    const Between x = between({level.width, clamp}, u), y = between({level.height, clamp}, v);
    const auto row = [&](int j) {
        const std::uint8_t* codes =
            level.alpha.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(level.width);
        const auto left = static_cast<float>(codes[x.first]), right = static_cast<float>(codes[x.second]);
        return left + (right - left) * x.share;
    };
    const float top = row(y.first), low = row(y.second);
    return top + (low - top) * y.share;
}

} // namespace

double covered_area(const MaskLevel<std::uint8_t>& level, const MaskTest& test)
{
    const Axis across{level.width, test.clamp}, down{level.height, test.clamp};
    const double cut = static_cast<double>(test.cutoff) * 255;
    const int lowest_solid = static_cast<int>(std::ceil(cut));
    double area = 0;
    for (int y = down.first(); y < level.height; ++y) {
        const auto row = [&](int j) {
            return level.alpha.data() + static_cast<std::size_t>(down.texel(j)) * static_cast<std::size_t>(level.width);
        };
        const std::uint8_t *top = row(y), *low = row(y + 1);
        double row_area = 0;
        for (int x = across.first(); x < level.width; ++x) {
            const int l = across.texel(x), r = across.texel(x + 1);
            const std::array<int, 4> codes{top[l], top[r], low[l], low[r]};
            const int solid = (codes[0] >= lowest_solid) + (codes[1] >= lowest_solid) + (codes[2] >= lowest_solid) +
                              (codes[3] >= lowest_solid);
            if (solid == 0) continue;
            const double share =
                solid == 4 ? 1 : covered_share({codes[0] - cut, codes[1] - cut, codes[2] - cut, codes[3] - cut});
            row_area += share * across.width(x);
        }
        area += row_area * down.width(y);
    }
    return area / (static_cast<double>(level.width) * level.height);
}

bool mix_well(const MaskLevel<std::uint8_t>& fine, const MaskLevel<std::uint8_t>& coarse, const MaskTest& test,
              double wanted)
{
    constexpr std::array<float, 3> shares{0.25f, 0.5f, 0.75f};
    const std::size_t points = std::clamp<std::size_t>(fine.alpha.size() * 16, 2048, std::size_t{1} << 15);
    const float cut = test.cutoff * 255;
    std::array<int, shares.size()> covered{};
    std::uint32_t u = 0x80000000u, v = u;
    for (std::size_t i = 0; i < points; ++i) {
        const float a = sample(fine, test.clamp, u, v), b = sample(coarse, test.clamp, u, v);
        for (std::size_t k = 0; k < shares.size(); ++k) covered[k] += a + (b - a) * shares[k] >= cut ? 1 : 0;
        // Evenly spread at any number. Source: Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences".
        u += 0xC13FA9A9u;
        v += 0x91E10DA5u;
    }
    const double tolerance = mixed_area_tolerance * std::min(wanted, 1 - wanted);
    return std::all_of(covered.begin(), covered.end(), [&](int count) {
        return std::abs(static_cast<double>(count) / static_cast<double>(points) - wanted) <= tolerance;
    });
}

double deviation_of(std::span<const float> alpha)
{
    double sum = 0, squares = 0;
    for (const float a : alpha) {
        sum += static_cast<double>(a);
        squares += static_cast<double>(a) * static_cast<double>(a);
    }
    const double count = static_cast<double>(std::max<std::size_t>(alpha.size(), 1)), mean = sum / count;
    return std::sqrt(std::max(0.0, squares / count - mean * mean));
}

std::optional<MaskLevel<std::uint8_t>> fit_mask(const MaskLevel<float>& mean, const MaskTest& test, double wanted,
                                                double deviation)
{
    MaskLevel<std::uint8_t> out{mean.width, mean.height, std::vector<std::uint8_t>(mean.alpha.size())};
    const double spread = std::max(deviation_of(mean.alpha), 1e-6);
    const auto contrast = static_cast<float>(std::clamp(deviation / spread, 1.0, largest_contrast));
    // `threshold` is the average alpha that is mapped to the cutoff: a larger value makes less of the mask solid.
    const auto area_at = [&](float threshold) {
        for (std::size_t i = 0; i < out.alpha.size(); ++i) {
            const float a = test.cutoff + contrast * (mean.alpha[i] - threshold);
            out.alpha[i] = static_cast<std::uint8_t>(std::clamp(a, 0.0f, 1.0f) * 255.0f + 0.5f);
        }
        return covered_area(out, test);
    };
    const auto [least, most] = std::minmax_element(mean.alpha.begin(), mean.alpha.end());
    float low = *least - 1 / contrast, high = *most + 1 / contrast, threshold = test.cutoff;
    const double tolerance = mask_area_tolerance * std::min(wanted, 1 - wanted);
    double best_error = 2;
    float best = threshold;
    for (int i = 0; i < search_steps; ++i) {
        const double area = area_at(threshold), error = std::abs(area - wanted);
        if (error < best_error) {
            best_error = error;
            best = threshold;
        }
        if (error <= tolerance / 8) break;
        (area > wanted ? low : high) = threshold;
        threshold = (low + high) / 2;
    }
    if (best_error > tolerance) return {};
    static_cast<void>(area_at(best));
    return out;
}

} // namespace atrium
