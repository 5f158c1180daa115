// Viridis: false colours that look evenly spaced, also without colour vision and in grey.
#ifndef SHARED_VIRIDIS_H
#define SHARED_VIRIDIS_H
#include "types.h"
SHARED_BEGIN

// Every 15th of its 256 colours, sRGB-encoded in 8 bits. Source: van der Walt & Smith 2015, "A Better Default Colormap
// for Matplotlib", whose table is in the public domain.
const vec3 viridis_colors[18] = {vec3(68, 1, 84),    vec3(72, 23, 105),  vec3(71, 42, 122),  vec3(67, 61, 132),
                                 vec3(61, 78, 138),  vec3(53, 94, 141),  vec3(46, 109, 142), vec3(41, 123, 142),
                                 vec3(35, 137, 142), vec3(31, 151, 139), vec3(33, 165, 133), vec3(46, 179, 124),
                                 vec3(70, 192, 111), vec3(101, 203, 94), vec3(137, 213, 72), vec3(176, 221, 47),
                                 vec3(216, 226, 25), vec3(253, 231, 37)};

/// The colour at `t`, 0 to 1, sRGB-encoded.
#ifdef __cplusplus
inline
#endif
vec3 viridis(float t)
{
    float x = 17.0f * t;
    int below = x < 16.0f ? int(x) : 16;
    return mix(viridis_colors[below], viridis_colors[below + 1], x - float(below)) / 255.0f;
}

SHARED_END
#endif
