// Linearly transformed cosines that stand for the specular lobe: one entry of their table. Made by scripts/fit_ltc.
#ifndef SHARED_LTC_H
#define SHARED_LTC_H
#include "types.h"
SHARED_BEGIN

const uint ltc_size = 32;           // entries along each axis
const float ltc_rough_min = 0.045; // perceptual roughness of the first row, min_roughness of lib/brdf.glsl; last row: 1

/// Entry (i, j) is that of the i-th roughness and of n.v = (j / (ltc_size - 1))^2. The surface's normal is z, the eye
/// lies in y = 0 at x <= 0. A direction l of the lobe comes from ((x - skew z) / along, y / across, z) of the cosine. A
/// narrow lobe has along = 2 alpha / (n.v)^2, across = 2 alpha, skew = t, with alpha = roughness^2 and t the tangent of
/// the eye's angle; the table holds how wide ones differ.
struct LtcEntry {
    float log2_along;   // log2(along (n.v)^2 / (2 alpha))
    float log2_across;  // log2(across / (2 alpha))
    float skew;         // skew / t
    float albedo;       // of the lobe where F = 1: integral of D V n.l
    float fresnel;      // the same of D V n.l (1 - v.h)^5
};

SHARED_END
#ifdef __cplusplus
static_assert(sizeof(atrium::shared::LtcEntry) == 20);
#endif
#endif
