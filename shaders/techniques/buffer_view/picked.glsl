// What of a texel is looked at.
#ifndef PICKED_GLSL
#define PICKED_GLSL
#include "shared/buffer_view.h"

/// The values that count: the first alone, unless `pick` is pick_all.
vec3 picked(vec4 texel, uint pick)
{
    if (pick == pick_all) return texel.rgb;
    if (pick == pick_length) return vec3(length(texel.rgb));
    if (pick == pick_none) return vec3(0.0);
    return vec3(texel[pick]);
}

#endif
