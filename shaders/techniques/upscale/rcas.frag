#version 460
// RCAS, the sharpening pass of FSR 1: takes a share of the four neighbours away from each pixel, as large as no colour
// channel leaves 0 to 1. Source: Lottes & AMD 2021, "FidelityFX Super Resolution 1.0".
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "shared/upscale.h"
#include "techniques/upscale/approximate.glsl"

layout(push_constant, scalar) uniform Push { SharpenPush push; };
layout(PASS_IMAGE(0)) uniform texture2D source; // encoded for display, 0 to 1
layout(location = 0) out vec4 out_color;

const float most_negative_weight = -0.1875; // 1/16 above -1/4, where the sum of weights would be 0

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(source, 0) - 1;
    vec3 e = texelFetch(source, pixel, 0).rgb;
    vec3 up = texelFetch(source, ivec2(pixel.x, max(pixel.y - 1, 0)), 0).rgb;
    vec3 left = texelFetch(source, ivec2(max(pixel.x - 1, 0), pixel.y), 0).rgb;
    vec3 right = texelFetch(source, ivec2(min(pixel.x + 1, last.x), pixel.y), 0).rgb;
    vec3 down = texelFetch(source, ivec2(pixel.x, min(pixel.y + 1, last.y)), 0).rgb;

    vec3 low = min(min(up, left), min(right, down)), high = max(max(up, left), max(right, down));
    // The weights at which the result would leave 0 and 1. Around black and white one of them is 0/0: the other counts.
    vec3 to_black = -min(low, e) / (4.0 * high), to_white = (1.0 - max(high, e)) / (4.0 * low - 4.0);
    vec3 weights = mix(max(to_black, to_white), to_white, equal(high, vec3(0.0)));
    weights = mix(weights, to_black, equal(low, vec3(1.0)));
    float weight = max(max(weights.r, weights.g), weights.b);
    weight = clamp(weight, most_negative_weight, 0.0) * push.strength;
    out_color = vec4((weight * (up + left + right + down) + e) * medium_reciprocal(4.0 * weight + 1.0), 1.0);
}
