#pragma once
// Pictures of the renderer against known ones: how far they agree, and what to keep of a failure.

#include "renderer/core/image.hpp"
#include "renderer/core/math.hpp"
#include "tests/truth/mask.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace atrium::truth {

/// How a picture is shown when a comparison failed.
enum class Show { depth, direction, index, value };

/// Errors are >= 0; `mean` keeps the sign. All are over the compared pixels: those of the mask, less the pixels that
/// both pictures call background.
struct Agreement {
    double tolerance = 0;
    std::size_t compared = 0;
    double share_within = 0; ///< of the compared pixels, error <= tolerance; 0 when nothing was compared
    double worst = 0;
    ivec2 worst_pixel{-1, -1}; ///< (x, y), y from the top
    double mean = 0, rmse = 0; ///< over finite errors
    double p99 = 0;            ///< 99 of 100 pixels are no worse
    double excluded_share = 0; ///< of the whole picture, what the mask left out
    Show show = Show::value;
    ImageF expected, actual, error; ///< error: 1 channel, 0 where not compared

    [[nodiscard]] std::string text() const; ///< one line
};

/// All take pictures and a mask of one size (Error(input) otherwise); `mask` is set where pixels count.
/// Depth, relative to the truth's. A surface where the other has background is infinitely wrong.
[[nodiscard]] Agreement compare_depth(const ImageF& truth, const ImageF& actual, const Mask& mask,
                                      double relative_tolerance);
/// Directions of 3 channels, degrees between them; (0,0,0) is background. Lengths other than 1 within 1 % count as 180.
[[nodiscard]] Agreement compare_directions(const ImageF& truth, const ImageF& actual, const Mask& mask,
                                           double degrees_tolerance);
/// Indices: error 0 or 1; background is -1.
[[nodiscard]] Agreement compare_indices(const ImageF& truth, const ImageF& actual, const Mask& mask);
/// Largest difference over channels, absolute; there is no background.
[[nodiscard]] Agreement compare_values(const ImageF& truth, const ImageF& actual, const Mask& mask, double tolerance);

/// Where failures are written: the environment's ATRIUM_TEST_OUT, else "atrium-test-out" in the temporary folder.
[[nodiscard]] std::filesystem::path failure_folder();
/// Writes NAME-expected.png, NAME-actual.png and NAME-difference.png (black: equal, white: twice the tolerance or more)
/// there, and returns a text that says where.
std::string write_failure(const std::string& name, const Agreement& agreement);

} // namespace atrium::truth
