#version 460
// An image of the frame graph as floats.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"

layout(PASS_IMAGE(0)) uniform texture2D image;
layout(location = 0) out vec4 out_value;

void main() { out_value = texelFetch(image, ivec2(gl_FragCoord.xy), 0); }
