#version 460
// floor.t16: 16 bilinear taps of an RGBA8 image at each pixel. The unit in which costs on a device are told.
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/pass.glsl"
#include "lib/textures.glsl"

layout(PASS_IMAGE(0)) uniform texture2D source;
layout(location = 0) out vec4 out_color;

void main()
{
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 16; ++i) {
        vec2 offset = vec2(float(i & 3) - 1.25, float(i >> 2) - 1.25);
        sum += textureLod(sampler2D(source, samplers[sampler_linear_clamp]), (gl_FragCoord.xy + offset) * frame.inv_size, 0.0);
    }
    out_color = sum * (1.0 / 16.0);
}
