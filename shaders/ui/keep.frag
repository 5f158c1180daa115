#version 460
// The picture, kept for the window: encoded, as the interface over it is.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"

layout(PASS_IMAGE(0)) uniform texture2D picture; // sRGB: reading it decodes
layout(location = 0) out vec4 out_color;

/// Source: IEC 61966-2-1.
vec3 srgb_encode(vec3 c) { return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308))); }

void main() { out_color = vec4(srgb_encode(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb), 1.0); }
