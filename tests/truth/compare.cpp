#include "tests/truth/compare.hpp"

#include "renderer/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace atrium::truth {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

void need_same_size(const ImageF& truth, const ImageF& actual, const Mask& mask, int channels)
{
    const bool same = truth.width == actual.width && truth.height == actual.height && truth.width == mask.width &&
                      truth.height == mask.height && truth.channels == actual.channels;
    if (same && (channels == 0 || truth.channels == channels)) return;
    throw Error(ExitCode::input, "pictures cannot be compared", "",
                fmt::format("truth {}x{}x{}, actual {}x{}x{}, mask {}x{}", truth.width, truth.height, truth.channels,
                            actual.width, actual.height, actual.channels, mask.width, mask.height),
                "compare pictures of one size");
}

/// Error of one pixel, signed where that means something.
struct PixelError {
    bool compared = true;
    double value = 0;
};

/// Walks the mask. `error_of(truth pixel, actual pixel)` gives a PixelError.
template <class F>
Agreement walk(const ImageF& truth, const ImageF& actual, const Mask& mask, double tolerance, Show show, F error_of)
{
    Agreement a;
    a.tolerance = tolerance;
    a.show = show;
    a.expected = truth;
    a.actual = actual;
    a.error = ImageF(truth.width, truth.height, 1);
    a.excluded_share = 1 - mask.share();
    std::vector<double> errors;
    double sum = 0, squares = 0;
    std::size_t within = 0, finite = 0;
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            if (!mask.at(x, y)) continue;
            const PixelError e = error_of(truth.at(x, y), actual.at(x, y));
            if (!e.compared) continue;
            const double size = std::isnan(e.value) ? infinite : std::abs(e.value);
            *a.error.at(x, y) = static_cast<float>(size);
            errors.push_back(size);
            if (size <= tolerance) ++within;
            if (a.worst_pixel.x < 0 || size > a.worst) {
                a.worst = size;
                a.worst_pixel = {x, y};
            }
            if (std::isfinite(size)) {
                sum += e.value;
                squares += size * size;
                ++finite;
            }
        }
    }
    a.compared = errors.size();
    if (errors.empty()) return a;
    a.share_within = static_cast<double>(within) / static_cast<double>(errors.size());
    if (finite > 0) {
        a.mean = sum / static_cast<double>(finite);
        a.rmse = std::sqrt(squares / static_cast<double>(finite));
    }
    const auto p99 = errors.begin() + static_cast<std::ptrdiff_t>((errors.size() - 1) * 99 / 100);
    std::nth_element(errors.begin(), p99, errors.end());
    a.p99 = *p99;
    return a;
}

} // namespace

Agreement compare_depth(const ImageF& truth, const ImageF& actual, const Mask& mask, double relative_tolerance)
{
    need_same_size(truth, actual, mask, 1);
    return walk(truth, actual, mask, relative_tolerance, Show::depth, [](const float* t, const float* a) {
        const double expected = static_cast<double>(*t), found = static_cast<double>(*a);
        if (std::isinf(expected) && expected == found) return PixelError{false};
        if (!std::isfinite(expected) || !std::isfinite(found)) return PixelError{true, infinite};
        return PixelError{true, (found - expected) / expected};
    });
}

Agreement compare_directions(const ImageF& truth, const ImageF& actual, const Mask& mask, double degrees_tolerance)
{
    need_same_size(truth, actual, mask, 3);
    return walk(truth, actual, mask, degrees_tolerance, Show::direction, [](const float* t, const float* a) {
        const glm::dvec3 expected(t[0], t[1], t[2]), found(a[0], a[1], a[2]);
        const double expected_length = glm::length(expected), length = glm::length(found);
        if (expected_length == 0 && length == 0) return PixelError{false};
        if (expected_length == 0 || !(std::abs(length - 1) <= 0.01)) return PixelError{true, 180};
        // atan2 keeps small angles, where acos of a cosine near 1 would lose them.
        const double radians = std::atan2(glm::length(glm::cross(expected, found)), glm::dot(expected, found));
        return PixelError{true, radians * 180 / 3.14159265358979323846};
    });
}

Agreement compare_indices(const ImageF& truth, const ImageF& actual, const Mask& mask)
{
    need_same_size(truth, actual, mask, 1);
    return walk(truth, actual, mask, 0, Show::index, [](const float* t, const float* a) {
        if (*t == -1.0f && *a == -1.0f) return PixelError{false};
        return PixelError{true, *t == *a ? 0.0 : 1.0};
    });
}

Agreement compare_values(const ImageF& truth, const ImageF& actual, const Mask& mask, double tolerance)
{
    need_same_size(truth, actual, mask, 0);
    return walk(truth, actual, mask, tolerance, Show::value, [&](const float* t, const float* a) {
        double largest = 0;
        for (int c = 0; c < truth.channels; ++c) {
            const double d = t[c] == a[c] ? 0 : static_cast<double>(a[c]) - static_cast<double>(t[c]);
            if (!(std::abs(d) <= std::abs(largest))) largest = d;
        }
        return PixelError{true, largest};
    });
}

std::string Agreement::text() const
{
    return fmt::format(
        "{:.3f} % of {} pixels within {:g}; worst {:.4g} at {},{}; mean {:.3g}, rmse {:.3g}, p99 {:.3g}; "
        "{:.2f} % excluded",
        100 * share_within, compared, tolerance, worst, worst_pixel.x, worst_pixel.y, mean, rmse, p99,
        100 * excluded_share);
}

} // namespace atrium::truth
