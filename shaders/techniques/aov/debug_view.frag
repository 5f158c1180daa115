#version 460
// Makes a picture of an AOV.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "shared/aov.h"

layout(push_constant, scalar) uniform Push { DebugViewPush push; };
layout(PASS_IMAGE(0)) uniform texture2D source;
layout(location = 0) out vec4 out_color;

/// Neighbouring indices get colours far apart. Source: golden-ratio hue steps.
vec3 index_color(float index)
{
    if (index < 0.0) return vec3(0.0);
    float hue = fract(index * 0.61803399);
    vec3 c = clamp(abs(fract(hue + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return mix(vec3(1.0), c, 0.5 + 0.4 * fract(index * 0.381966)) * 0.8;
}

void main()
{
    vec4 v = texelFetch(source, ivec2(gl_FragCoord.xy * push.texels), 0);
    vec4 ranged = clamp((v - push.low) / (push.high - push.low), 0.0, 1.0);
    vec3 c = ranged.rgb;
    if (push.mode == view_scalar) c = ranged.rrr;
    if (push.mode == view_vector) c = v.rgb == vec3(0.0) ? vec3(0.0) : v.rgb * 0.5 + 0.5;
    if (push.mode == view_index) c = index_color(v.r);
    if (push.mode == view_motion) c = vec3(ranged.rg, 0.0);
    out_color = vec4(c, 1.0);
}
