#version 460
// Mixes the picture into the mean of the pictures before it.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"

layout(push_constant) uniform Push { float weight; }; // of this frame's picture
layout(PASS_IMAGE(0)) uniform texture2D picture;
layout(PASS_IMAGE(1)) uniform texture2D before;
layout(location = 0) out vec4 out_color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    out_color = mix(texelFetch(before, pixel, 0), texelFetch(picture, pixel, 0), weight);
}
