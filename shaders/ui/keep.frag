#version 460
// The picture, kept for the window.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"

layout(PASS_IMAGE(0)) uniform texture2D picture;
layout(location = 0) out vec4 out_color;

void main() { out_color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }
