#include "renderer/metrics/image_error.hpp"

#include "renderer/metrics/plane.hpp"

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

std::size_t color_channels(const ImageF& image)
{
    return static_cast<std::size_t>(std::min(image.channels, 3));
}

std::size_t pixels(const ImageF& image)
{
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

Plane luma(const ImageF& image)
{
    const auto channels = static_cast<std::size_t>(image.channels);
    return make_plane(image.width, image.height, [&](std::size_t i) {
        const float* c = &image.values[i * channels];
        return channels < 3 ? double{c[0]} : 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    });
}

Plane product(const Plane& a, const Plane& b)
{
    return make_plane(a.width, a.height, [&](std::size_t i) { return a.values[i] * b.values[i]; });
}

} // namespace

double mean_squared_error(const ImageF& reference, const ImageF& test)
{
    const auto stride = static_cast<std::size_t>(reference.channels);
    const std::size_t channels = color_channels(reference);
    double total = 0;
    for (std::size_t i = 0; i < pixels(reference); ++i) {
        for (std::size_t c = 0; c < channels; ++c) {
            const double difference = double{reference.values[i * stride + c]} - double{test.values[i * stride + c]};
            total += difference * difference;
        }
    }
    return total / static_cast<double>(pixels(reference) * channels);
}

std::optional<double> peak_signal_to_noise(double mse, double peak)
{
    if (mse == 0) return std::nullopt;
    return 10 * std::log10(peak * peak / mse);
}

std::optional<double> structural_similarity(const ImageF& reference, const ImageF& test)
{
    constexpr int radius = 5;
    constexpr double deviation = 1.5, k1 = 0.01 * 0.01, k2 = 0.03 * 0.03;
    if (reference.width <= 2 * radius || reference.height <= 2 * radius) return std::nullopt;
    const Kernel window =
        normalized(make_kernel(radius, [](double x) { return std::exp(-x * x / (2 * deviation * deviation)); }));
    const auto mean = [&](const Plane& plane) { return convolve(plane, window, window); };
    const Plane a = luma(reference), b = luma(test);
    const Plane mean_a = mean(a), mean_b = mean(b);
    const Plane mean_aa = mean(product(a, a)), mean_bb = mean(product(b, b)), mean_ab = mean(product(a, b));

    double total = 0;
    for (int y = radius; y < a.height - radius; ++y) {
        for (int x = radius; x < a.width - radius; ++x) {
            const double m1 = mean_a.row(y)[x], m2 = mean_b.row(y)[x];
            const double v1 = mean_aa.row(y)[x] - m1 * m1, v2 = mean_bb.row(y)[x] - m2 * m2;
            const double covariance = mean_ab.row(y)[x] - m1 * m2;
            total += (2 * m1 * m2 + k1) * (2 * covariance + k2) / ((m1 * m1 + m2 * m2 + k1) * (v1 + v2 + k2));
        }
    }
    return total / (static_cast<double>(a.width - 2 * radius) * (a.height - 2 * radius));
}

double peak_of(const ImageF& image)
{
    const auto stride = static_cast<std::size_t>(image.channels);
    double peak = 0;
    for (std::size_t i = 0; i < pixels(image); ++i) {
        for (std::size_t c = 0; c < color_channels(image); ++c)
            peak = std::max(peak, double{image.values[i * stride + c]});
    }
    return peak;
}

} // namespace atrium
