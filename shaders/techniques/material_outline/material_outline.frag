#version 460
// A line along the inner edge of one material's pixels; the rest of the picture stays.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "lib/scene.glsl"

layout(push_constant) uniform Push { uint material; };
layout(PASS_IMAGE(0)) uniform utexture2D id; // record + 1 above the lowest 8 bits; 0 is the background
layout(location = 0) out vec4 out_color;

const int width = 2; // pixels
const ivec2 directions[4] = ivec2[](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));

bool is_material(ivec2 pixel)
{
    uint record = texelFetch(id, clamp(pixel, ivec2(0), textureSize(id, 0) - 1), 0).x >> 8;
    return record != 0u && record_table[record - 1u].material == material;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (!is_material(pixel)) discard;
    for (int i = 0; i < 4; ++i) {
        if (is_material(pixel + width * directions[i])) continue;
        out_color = vec4(1.0, 0.42, 0.03, 1.0);
        return;
    }
    discard;
}
