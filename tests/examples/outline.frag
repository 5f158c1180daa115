#version 460
// Darkens a pixel where the mesh beside it is another one and lies behind it.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"

layout(push_constant) uniform Push { float darkness; };  // 0: no line, 1: a black one
layout(PASS_IMAGE(0)) uniform utexture2D id;             // record + 1 above the lowest 8 bits; 0 is the background
layout(PASS_IMAGE(1)) uniform texture2D depth;           // reversed: larger is nearer
layout(PASS_IMAGE(2)) uniform texture2D picture;
layout(location = 0) out vec4 out_color;

const ivec2 beside[4] = ivec2[](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(id, 0) - 1;
    uint mesh = texelFetch(id, pixel, 0).x >> 8;
    float own_depth = texelFetch(depth, pixel, 0).x;
    float line = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 other = clamp(pixel + beside[i], ivec2(0), last);
        bool ends = texelFetch(id, other, 0).x >> 8 != mesh;
        if (ends && texelFetch(depth, other, 0).x <= own_depth) line = darkness;
    }
    out_color = vec4(texelFetch(picture, pixel, 0).rgb * (1.0 - line), 1.0);
}
