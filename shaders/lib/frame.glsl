// The frame's constants and what follows from them directly.
#ifndef FRAME_GLSL
#define FRAME_GLSL
#include "shared/frame.h"

layout(set = 1, binding = 0, scalar) uniform FrameBlock { FrameConstants frame; };

/// Direction through a pixel, not normalised: it has length 1 along the view axis. `pixel` in pixels from the top left.
vec3 view_ray(vec2 pixel)
{
    vec2 ndc = vec2(2.0, -2.0) * pixel * frame.inv_size + vec2(-1.0, 1.0);
    return frame.ray_forward + (ndc.x * frame.tan_x) * frame.right + (ndc.y * frame.tan_y) * frame.up;
}

/// Distance along the view axis, m, from reversed infinite depth.
float view_distance(float depth) { return frame.near / depth; }

#endif
