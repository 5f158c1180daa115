// Pictures of failed comparisons, as a person can look at them.

#include "tests/truth/compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace atrium::truth {
namespace {

std::uint8_t to_byte(double unit)
{
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(std::isnan(unit) ? 1.0 : unit, 0.0, 1.0)));
}

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

    [[nodiscard]] double place(float v) const
    {
        return high > low ? (static_cast<double>(v) - low) / (high - low) : 0.5;
    }
};

/// Of the finite values of the expected picture, so that both pictures are shown alike.
Range range_of(const ImageF& image)
{
    Range r;
    for (const float f : image.values) {
        if (!std::isfinite(f)) continue;
        r.low = std::min(r.low, static_cast<double>(f));
        r.high = std::max(r.high, static_cast<double>(f));
    }
    return r;
}

/// A colour for an index: neighbours far apart. Source: the golden angle.
glm::dvec3 index_color(float index)
{
    if (index < 0) return glm::dvec3(0);
    const double hue = 2.39996322972865332 * static_cast<double>(index);
    return {0.5 + 0.45 * std::cos(hue), 0.5 + 0.45 * std::cos(hue + 2.0944), 0.5 + 0.45 * std::cos(hue + 4.1888)};
}

Image8 shown(const ImageF& image, Show show, const Range& range)
{
    Image8 out(image.width, image.height, 3);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const float* from = image.at(x, y);
            const glm::dvec3 color = index_color(from[0]);
            for (int c = 0; c < 3; ++c) {
                const float value = from[std::min(c, image.channels - 1)];
                double unit = range.place(value);
                if (show == Show::direction) unit = 0.5 + 0.5 * static_cast<double>(value);
                if (show == Show::index) unit = color[c];
                out.at(x, y)[c] = to_byte(unit);
            }
        }
    }
    return out;
}

} // namespace

std::filesystem::path failure_folder()
{
    const char* folder = std::getenv("ATRIUM_TEST_OUT");
    if (folder != nullptr && *folder != '\0') return folder;
    return std::filesystem::temp_directory_path() / "atrium-test-out";
}

std::string write_failure(const std::string& name, const Agreement& a)
{
    const std::filesystem::path folder = failure_folder();
    std::filesystem::create_directories(folder);
    const Range range = range_of(a.expected);
    write_png(folder / (name + "-expected.png"), shown(a.expected, a.show, range));
    write_png(folder / (name + "-actual.png"), shown(a.actual, a.show, range));
    const Range error{0, a.tolerance > 0 ? 2 * a.tolerance : 1};
    write_png(folder / (name + "-difference.png"), shown(a.error, Show::value, error));
    return "pictures: " + (folder / name).string() + "-{expected,actual,difference}.png";
}

} // namespace atrium::truth
