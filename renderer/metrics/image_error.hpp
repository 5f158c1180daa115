#pragma once
// How far two pictures of the same size differ, in single numbers: mean squared error, peak signal to noise ratio and
// structural similarity (Wang, Bovik, Sheikh & Simoncelli 2004, "Image Quality Assessment: From Error Visibility to
// Structural Similarity"). Alpha does not count.

#include "renderer/core/image.hpp"

#include <optional>

namespace atrium {

/// The mean of the squared differences over all pixels and colour channels.
[[nodiscard]] double mean_squared_error(const ImageF& reference, const ImageF& test);

/// 10 log10(peak² / mse), dB. Nothing if the pictures are equal: it is infinite.
[[nodiscard]] std::optional<double> peak_signal_to_noise(double mse, double peak);

/// The mean over all windows of 11 x 11 pixels, Gaussian with a standard deviation of 1.5 pixels, that lie in the
/// picture; of luma (Rec. 709) of encoded values in 0 to 1. 1: equal. Nothing if the picture is smaller than a window.
[[nodiscard]] std::optional<double> structural_similarity(const ImageF& reference, const ImageF& test);

/// The largest colour value.
[[nodiscard]] double peak_of(const ImageF& image);

} // namespace atrium
