#pragma once
// Fits a linearly transformed cosine to the specular lobe of shaders/lib/brdf.glsl. Source: Heitz, Dupuy, Hill, Neubelt
// 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines".

#include "shaders/shared/ltc.h"

namespace atrium {

/// Perceptual roughness of a row and cosine to the eye of a column of the table. The ends of the latter are drawn in a
/// little: at a right angle and straight above, the matrix or its share that belongs to the slant is not defined.
[[nodiscard]] double ltc_roughness(unsigned row);
[[nodiscard]] double ltc_cosine(unsigned column);

/// The lobe g whose logarithm differs least from that of f = D V n.l but for a factor, weighted with f: what matters is
/// that f / g be even, because the shader corrects g by f at a few points. Both ends of every lobe are fitted alone,
/// without a neighbour's help. Cost: about 10 ms.
[[nodiscard]] shared::LtcEntry fit_ltc(double roughness, double n_v);

} // namespace atrium
