// What both methods of ambient occlusion and their filters stand on: points of the view, and a pattern of noise.
//
// View space here: x right, y up, z towards the eye, m. An AO image holds visibility and the distance along the view axis
// of the pixel that it was reckoned for; of a half-size image that is the upper left of four, never an average of them.
#include "lib/depth_normal.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "shared/ao.h"

layout(push_constant, scalar) uniform Push { AoPush push; };

const float no_surface = 0.0; // in place of a distance

/// Through the centre of a full-size pixel, with length 1 along the view axis.
vec3 ray_of(ivec2 pixel)
{
    vec2 ndc = vec2(2.0, -2.0) * (vec2(pixel) + 0.5) * frame.inv_size + frame.corner;
    return vec3(ndc * vec2(frame.tan_x, frame.tan_y), -1.0);
}

vec3 to_view(vec3 world) { return vec3(dot(world, frame.right), dot(world, frame.up), -dot(world, frame.forward)); }

/// Unit normal of the pixel's triangle, view space. Not the normal map's: its bumps occlude nothing.
vec3 plane_normal(ivec2 pixel) { return to_view(fetch_geometric_normal(pixel)); }

/// What a visibility becomes once its noise is averaged.
float finished(float ao) { return pow(max(ao, 0.0), push.power); }

/// What goes on of a noisy one: all of it, be it under 0 or over 1, where a blur follows.
float reckoned(float ao) { return push.blur == 1u ? ao : finished(ao); }

/// The pixel that a texel of an AO image stands for.
ivec2 pixel_of(ivec2 texel) { return texel * int(push.scale); }

/// How alike two surfaces are, by the distance of `q` from the plane through `p`, m. Source: Tomasi, Manduchi
/// 1998, "Bilateral Filtering"; Kopf et al. 2007, "Joint Bilateral Upsampling".
float plane_weight(vec3 p, vec3 normal, vec3 q)
{
    return exp(-abs(dot(normal, q - p)) / (0.005 * -p.z));
}
