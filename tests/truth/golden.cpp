#include "tests/truth/golden.hpp"

#include "tests/truth/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace atrium::truth {
namespace {

constexpr int difference_gain = 8; ///< differences are shown this much stronger

bool asked_to_update()
{
    const char* update = std::getenv("ATRIUM_UPDATE_GOLDENS");
    return update != nullptr && std::string_view(update) == "1";
}

std::string save(const std::string& name, const char* kind, const Image8& image)
{
    const std::filesystem::path folder = failure_folder();
    std::filesystem::create_directories(folder);
    const std::filesystem::path file = folder / (name + "-" + kind + ".png");
    write_png(file, image);
    return file.string();
}

/// Figures into `result`; returns the differences, amplified.
Image8 measure(const Image8& actual, const Image8& expected, int limit, GoldenResult& result)
{
    Image8 difference(actual.width, actual.height, actual.channels);
    const auto channels = static_cast<std::size_t>(actual.channels);
    std::size_t failing = 0;
    double squares = 0;
    for (std::size_t pixel = 0; pixel < actual.values.size(); pixel += channels) {
        int worst = 0;
        for (std::size_t i = pixel; i < pixel + channels; ++i) {
            const int d = std::abs(int{actual.values[i]} - int{expected.values[i]});
            worst = std::max(worst, d);
            squares += d * d;
            difference.values[i] = static_cast<std::uint8_t>(std::min(255, d * difference_gain));
        }
        if (channels == 4) difference.values[pixel + 3] = 255; // or a viewer would hide it
        if (worst > limit) ++failing;
        result.largest_difference = std::max(result.largest_difference, worst);
    }
    const auto values = static_cast<double>(std::max<std::size_t>(1, actual.values.size()));
    result.failing_share = static_cast<double>(failing * channels) / values;
    result.rmse = std::sqrt(squares / values);
    return difference;
}

} // namespace

GoldenResult compare_golden(const Image8& actual, const std::filesystem::path& golden, int max_channel_difference,
                            double max_share)
{
    GoldenResult result;
    if (asked_to_update()) {
        write_png(golden, actual);
        result.passed = true;
        result.text = "written anew: " + golden.string();
        return result;
    }
    const std::string name = golden.stem().string();
    if (!std::filesystem::exists(golden)) {
        result.text =
            fmt::format("there is no golden {}; the picture is {}", golden.string(), save(name, "actual", actual));
        return result;
    }
    const Image8 expected = read_png(golden);
    if (expected.width != actual.width || expected.height != actual.height || expected.channels != actual.channels) {
        result.text =
            fmt::format("{} is {}x{}x{}, the picture {}x{}x{}: {}", golden.string(), expected.width, expected.height,
                        expected.channels, actual.width, actual.height, actual.channels, save(name, "actual", actual));
        return result;
    }
    const Image8 difference = measure(actual, expected, max_channel_difference, result);
    result.passed = result.failing_share <= max_share;
    result.text = fmt::format(
        "{}: {:.4f} % of pixels differ by more than {} (allowed {:.4f} %), largest {}, rmse {:.3f}", name,
        100 * result.failing_share, max_channel_difference, 100 * max_share, result.largest_difference, result.rmse);
    if (!result.passed) {
        save(name, "expected", expected);
        save(name, "actual", actual);
        result.text += fmt::format("; difference x {}: {}", difference_gain, save(name, "difference", difference));
    }
    return result;
}

} // namespace atrium::truth
