#version 460
// An image of whole numbers as floats: exact up to 2^24, to 24 bits beyond.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"

layout(PASS_IMAGE(0)) uniform utexture2D image;
layout(location = 0) out vec4 out_value;

void main() { out_value = vec4(texelFetch(image, ivec2(gl_FragCoord.xy), 0)); }
