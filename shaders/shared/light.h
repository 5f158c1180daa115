// A light as the shaders see it. Units: renderer/scene/light.hpp; colours are multiplied with the exposure.
#ifndef SHARED_LIGHT_H
#define SHARED_LIGHT_H
#include "types.h"
SHARED_BEGIN

const uint light_sun = 0, light_spot = 1, light_point = 2, light_rect = 3;
const uint light_capacity = 64;
const uint no_shadow_layer = 0xffffffffu;

/// Lights stand in the frame's table in this order: those without area (sun, spot, point), then rectangles.
struct GpuLight {
    vec3 position;      // m, world; sun: minus its direction
    uint type;
    vec3 direction;     // unit, that the light travels; rect: its normal
    float inv_range2;   // 1 / range^2; 0 where there is no range
    vec3 color;         // linear Rec.709 x illuminance, intensity or radiance x exposure
    float spot_scale;   // cone = sat(cos * scale + offset)^2; a point light has 0 and 1
    vec3 half_right;    // rect: from the centre to the middle of its right edge, m
    float spot_offset;
    vec3 half_up;       // rect: to the middle of its upper edge, m
    float sin2_radius;  // sun: squared sine of its angular radius
    uint shadow_layer;  // of the image of visibilities, or no_shadow_layer
    float local;        // 1 where the light has a place, 0 for a sun: l = position - local * p
};

SHARED_END
#ifdef __cplusplus
static_assert(sizeof(atrium::shared::GpuLight) == 88);
#endif
#endif
