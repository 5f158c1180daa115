#pragma once
// FLIP: the difference that a person sees between a picture and its reference when both are shown in turn.
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström & Fairchild 2020, "FLIP: A Difference Evaluator for Alternating
// Images"; for HDR: Andersson, Nilsson, Shirley & Akenine-Möller 2021, "Visualizing Errors in Rendered High Dynamic
// Range Images".

#include "renderer/core/image.hpp"

#include <numbers>

namespace atrium {

/// Of a screen of 3840 pixels over 0.7 m, seen from 0.7 m.
inline constexpr double flip_pixels_per_degree = 0.7 * 3840 / 0.7 * std::numbers::pi / 180;

/// Exposures in stops at which HDR pictures are compared.
struct FlipExposures {
    double start = 0, stop = 0;
    int count = 2;
};

/// Error of each pixel, one channel: 0, no visible difference, to 1. Pictures of three channels and one size, in
/// linear light from 0 to 1.
[[nodiscard]] ImageF flip_map(const ImageF& reference, const ImageF& test,
                              double pixels_per_degree = flip_pixels_per_degree);

/// From the exposure that shows the brightest pixel of the reference to the one that shows its median. Where more than
/// half of the pixels are black, the median of the others.
[[nodiscard]] FlipExposures flip_exposures(const ImageF& reference);

/// The largest error of each pixel over the exposures, tone mapped with ACES. Linear, of any range, all values finite.
[[nodiscard]] ImageF flip_map_hdr(const ImageF& reference, const ImageF& test, const FlipExposures& exposures,
                                  double pixels_per_degree = flip_pixels_per_degree);

/// sRGB's decoding of an encoded value, both 0 to 1.
[[nodiscard]] double linear_from_srgb(double encoded);

[[nodiscard]] double mean_of(const ImageF& map);

/// A picture of an error map: dark for 0, bright for 1 (the colour map magma).
[[nodiscard]] Image8 heat_map(const ImageF& map);

} // namespace atrium
