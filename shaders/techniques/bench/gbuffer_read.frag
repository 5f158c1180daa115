#version 460
// floor.lighting: reads what lighting reads and writes one target; nothing else.
#extension GL_GOOGLE_include_directive : require
#include "lib/gbuffer.glsl"

layout(location = 0) out vec4 out_radiance;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
    uvec2 normals = texelFetch(gbuffer_normal, pixel, 0).xy;
    uint id = texelFetch(gbuffer_id, pixel, 0).x;
    uint emission = texelFetch(gbuffer_emission, pixel, 0).x;
    float depth = texelFetch(gbuffer_depth, pixel, 0).x;
    out_radiance = albedo + vec4(uintBitsToFloat(normals), depth, uintBitsToFloat(id ^ emission));
}
