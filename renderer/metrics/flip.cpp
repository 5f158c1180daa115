#include "renderer/metrics/flip.hpp"

#include "renderer/core/jobs.hpp"
#include "renderer/core/math.hpp"
#include "renderer/metrics/plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace atrium {
namespace {

using Color = glm::dvec3;

/// Three planes: a picture in some colour space.
using Planes = std::array<Plane, 3>;

// Columns of the matrix from linear Rec. 709 to XYZ, D65, and the other way.
const glm::dmat3 xyz_from_rgb{10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382,
                              8788810.0 / 24577794,  8788810.0 / 12288897, 8788810.0 / 73733382,
                              4435075.0 / 24577794,  887015.0 / 12288897,  70074185.0 / 73733382};
const Color white = xyz_from_rgb * Color(1);

/// Of XYZ divided by white: a lightness and two opponent colours; Lab if `v` went through lab_curve() first.
Color opponent(const Color& v)
{
    return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

Color xyz_from_opponent(const Color& c)
{
    const double y = (c.x + 16) / 116;
    return {c.y / 500 + y, y, y - c.z / 200};
}

double lab_curve(double t)
{
    constexpr double d = 6.0 / 29;
    return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
}

Color lab(const Color& rgb)
{
    const Color v = xyz_from_rgb * rgb / white;
    return opponent({lab_curve(v.x), lab_curve(v.y), lab_curve(v.z)});
}

/// Distance of two colours: HyAB of Lab colours with the Hunt effect (colours look stronger when bright), to the power
/// that keeps large distances from hiding others.
double color_distance(const Color& reference_rgb, const Color& test_rgb)
{
    const auto hunt = [](const Color& c) { return Color(c.x, 0.01 * c.x * c.y, 0.01 * c.x * c.z); };
    const Color difference = hunt(lab(reference_rgb)) - hunt(lab(test_rgb));
    return std::pow(std::abs(difference.x) + std::hypot(difference.y, difference.z), 0.7);
}

/// The distance scaled to 0 to 1: linearly up to a share of the largest distance, compressed above.
double scaled_color_distance(double distance, double largest)
{
    constexpr double share = 0.4, scaled_share = 0.95;
    const double knee = share * largest;
    if (distance < knee) return scaled_share * distance / knee;
    return scaled_share + (1 - scaled_share) * (distance - knee) / (largest - knee);
}

Planes opponent_planes(const ImageF& image)
{
    Planes out;
    out.fill(Plane(image.width, image.height));
    parallel_for(static_cast<std::size_t>(image.height), [&](std::size_t y) {
        for (int x = 0; x < image.width; ++x) {
            const float* rgb = image.at(x, static_cast<int>(y));
            const Color c = opponent(xyz_from_rgb * Color(rgb[0], rgb[1], rgb[2]) / white);
            for (int k = 0; k < 3; ++k) out[static_cast<std::size_t>(k)].row(static_cast<int>(y))[x] = c[k];
        }
    });
    return out;
}

/// Blurs with the contrast sensitivity of the eye: by little for lightness, by much for blue and yellow.
Planes as_seen(const Planes& planes, double pixels_per_degree)
{
    using std::numbers::pi;
    struct Gaussian {
        double a, b;
    };
    const auto radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * pixels_per_degree));
    const auto kernel = [&](const Gaussian& g) {
        return make_kernel(radius, [&](double x) {
            const double degrees = x / pixels_per_degree;
            return std::exp(-pi * pi * degrees * degrees / g.b);
        });
    };
    const auto blur = [&](const Plane& plane, const Gaussian& g) {
        const Kernel k = normalized(kernel(g));
        return convolve(plane, k, k);
    };
    constexpr Gaussian lightness{1, 0.0047}, red_green{1, 0.0053};
    constexpr Gaussian blue_yellow_1{34.1, 0.04}, blue_yellow_2{13.5, 0.025};
    // A sum of two Gaussians is not separable: each has the share that its kernel's sum over the plane has.
    const auto weight = [&](const Gaussian& g) {
        const double along = sum(kernel(g));
        return g.a * std::sqrt(pi / g.b) * along * along;
    };
    const double share = weight(blue_yellow_1) / (weight(blue_yellow_1) + weight(blue_yellow_2));
    const Plane first = blur(planes[2], blue_yellow_1), second = blur(planes[2], blue_yellow_2);
    return {blur(planes[0], lightness), blur(planes[1], red_green),
            make_plane(first.width, first.height,
                       [&](std::size_t i) { return share * first.values[i] + (1 - share) * second.values[i]; })};
}

/// Linear RGB, clamped to 0 to 1, of a pixel.
Color rgb_at(const Planes& planes, std::size_t i)
{
    static const glm::dmat3 rgb_from_xyz = glm::inverse(xyz_from_rgb);
    const Color xyz = xyz_from_opponent({planes[0].values[i], planes[1].values[i], planes[2].values[i]}) * white;
    return glm::clamp(rgb_from_xyz * xyz, Color(0), Color(1));
}

/// Strength of edges and points in a picture's lightness.
struct Features {
    Plane edges, points;
};

/// Positive and negative weights each scaled to sum to 1 and -1.
Kernel balanced(Kernel kernel)
{
    double positive = 0, negative = 0;
    for (const double w : kernel) (w > 0 ? positive : negative) += w;
    for (double& w : kernel) w /= w > 0 ? positive : -negative;
    return kernel;
}

Features features_of(const Plane& lightness, double pixels_per_degree)
{
    constexpr double width_in_degrees = 0.082; // of the features that the eye is most sensitive to
    const double deviation = 0.5 * width_in_degrees * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const auto gaussian = [&](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
    const Kernel smooth = normalized(make_kernel(radius, gaussian));
    const Kernel slope = balanced(make_kernel(radius, [&](double x) { return -x * gaussian(x); }));
    const Kernel bump =
        balanced(make_kernel(radius, [&](double x) { return (x * x / (deviation * deviation) - 1) * gaussian(x); }));
    const Plane y =
        make_plane(lightness.width, lightness.height, [&](std::size_t i) { return (lightness.values[i] + 16) / 116; });
    const Plane smooth_rows = convolve_rows(y, smooth);
    const auto strength = [&](const Kernel& kernel) {
        const Plane across = convolve_columns(convolve_rows(y, kernel), smooth);
        const Plane down = convolve_columns(smooth_rows, kernel);
        return make_plane(y.width, y.height,
                          [&](std::size_t i) { return std::hypot(across.values[i], down.values[i]); });
    };
    return {strength(slope), strength(bump)};
}

double luminance_of(const float* rgb)
{
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/// A rational curve that approximates ACES, of an exposed value.
double tone_mapped(double x)
{
    x = std::max(x, 0.0);
    const double value = (0.9036 * x * x + 0.018 * x) / (0.8748 * x * x + 0.354 * x + 0.14);
    return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 1;
}
constexpr double tone_mapped_085 = 2.118872; ///< its value is 0.85 there: almost white

ImageF exposed(const ImageF& image, double stops)
{
    ImageF out = image;
    const double factor = std::exp2(stops);
    for (float& value : out.values) value = static_cast<float>(tone_mapped(value * factor));
    return out;
}

} // namespace

double linear_from_srgb(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

ImageF flip_map(const ImageF& reference, const ImageF& test, double pixels_per_degree)
{
    const Planes reference_planes = opponent_planes(reference), test_planes = opponent_planes(test);
    const Planes seen_reference = as_seen(reference_planes, pixels_per_degree);
    const Planes seen_test = as_seen(test_planes, pixels_per_degree);
    const Features reference_features = features_of(reference_planes[0], pixels_per_degree);
    const Features test_features = features_of(test_planes[0], pixels_per_degree);
    const double largest = color_distance(Color(0, 1, 0), Color(0, 0, 1));

    ImageF map(reference.width, reference.height, 1);
    parallel_for(static_cast<std::size_t>(map.height), [&](std::size_t y) {
        for (std::size_t x = 0; x < static_cast<std::size_t>(map.width); ++x) {
            const std::size_t i = y * static_cast<std::size_t>(map.width) + x;
            const double color =
                scaled_color_distance(color_distance(rgb_at(seen_reference, i), rgb_at(seen_test, i)), largest);
            const double edge = std::abs(reference_features.edges.values[i] - test_features.edges.values[i]);
            const double point = std::abs(reference_features.points.values[i] - test_features.points.values[i]);
            const double feature = std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
            map.values[i] = static_cast<float>(std::pow(color, 1 - feature));
        }
    });
    return map;
}

FlipExposures flip_exposures(const ImageF& reference)
{
    std::vector<double> luminances;
    for (int y = 0; y < reference.height; ++y) {
        for (int x = 0; x < reference.width; ++x) luminances.push_back(luminance_of(reference.at(x, y)));
    }
    std::sort(luminances.begin(), luminances.end());
    double median = luminances[luminances.size() / 2];
    if (median <= 0) {
        luminances.erase(luminances.begin(), std::upper_bound(luminances.begin(), luminances.end(), 0.0));
        if (luminances.empty()) return {};
        median = luminances[luminances.size() / 2];
    }
    FlipExposures out{std::log2(tone_mapped_085 / luminances.back()), std::log2(tone_mapped_085 / median), 2};
    out.count = std::max(2, static_cast<int>(std::ceil(out.stop - out.start)));
    return out;
}

ImageF flip_map_hdr(const ImageF& reference, const ImageF& test, const FlipExposures& exposures,
                    double pixels_per_degree)
{
    ImageF largest(reference.width, reference.height, 1);
    for (int i = 0; i < exposures.count; ++i) {
        const double stops = exposures.start + i * (exposures.stop - exposures.start) / (exposures.count - 1);
        const ImageF map = flip_map(exposed(reference, stops), exposed(test, stops), pixels_per_degree);
        for (std::size_t p = 0; p < map.values.size(); ++p)
            largest.values[p] = std::max(largest.values[p], map.values[p]);
    }
    return largest;
}

double mean_of(const ImageF& map)
{
    return std::accumulate(map.values.begin(), map.values.end(), 0.0) / static_cast<double>(map.values.size());
}

Image8 heat_map(const ImageF& map)
{
    // Nine colours of Matplotlib's magma, evenly spaced.
    constexpr std::array<std::array<double, 3>, 9> colors{{{0, 0, 4},
                                                           {28, 16, 68},
                                                           {79, 18, 123},
                                                           {129, 37, 129},
                                                           {181, 54, 122},
                                                           {229, 80, 100},
                                                           {251, 135, 97},
                                                           {254, 194, 135},
                                                           {252, 253, 191}}};
    Image8 out(map.width, map.height, 3);
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        const double at = std::clamp(double{map.values[i]}, 0.0, 1.0) * (colors.size() - 1);
        const std::size_t first = std::min(static_cast<std::size_t>(at), colors.size() - 2);
        for (std::size_t c = 0; c < 3; ++c) {
            const double mixed = std::lerp(colors[first][c], colors[first + 1][c], at - static_cast<double>(first));
            out.values[3 * i + c] = static_cast<std::uint8_t>(std::lround(mixed));
        }
    }
    return out;
}

} // namespace atrium
