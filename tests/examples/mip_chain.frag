#version 460
// The mean of four texels of the next finer mip.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"

layout(PASS_IMAGE(0)) uniform texture2D finer; // one mip, bound as level 0
layout(location = 0) out vec4 out_color;

void main()
{
    ivec2 first = 2 * ivec2(gl_FragCoord.xy), last = textureSize(finer, 0) - 1;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) sum += texelFetch(finer, min(first + ivec2(i % 2, i / 2), last), 0);
    out_color = 0.25 * sum;
}
