#pragma once
// What `visibility.L` ought to be, by rays: for pictures of a camera.

#include "renderer/scene/light.hpp"
#include "tests/truth/primary.hpp"
#include "tests/truth/visibility.hpp"

namespace atrium::truth {

/// Visibility of a light at each pixel that primary rays hit, 1 elsewhere and where the light does not reach. With a
/// `count` of 1 the light is a point (a sun: one direction), else an area: a disc towards the surface, the sun's disc,
/// a rectangle.
[[nodiscard]] ImageF cast_visibility(const TruthScene& scene, const PrimaryBuffers& primary, const Light& light,
                                     int count);

/// Pixels that a comparison counts: a surface, off silhouettes (grown by a pixel), within cone and range and before a
/// rectangle's front, and facing the light at a cosine of 0.1 or more.
[[nodiscard]] Mask lit_pixels(const PrimaryBuffers& primary, const Light& light);

/// How far off a filter is, over the pixels of a mask.
struct VisibilityError {
    double wrong = 0;                            ///< share of pixels that differ by more than a half
    double rmse = 0;                             ///< over all
    double penumbra_rmse = 0, penumbra_bias = 0; ///< over those whose truth lies between 0.02 and 0.98
    double penumbra_share = 0;                   ///< of all
    double share = 0;                            ///< of the picture that was compared
};
[[nodiscard]] VisibilityError compare_visibility(const ImageF& truth, const ImageF& got, const Mask& mask);

} // namespace atrium::truth
