#version 460
// floor.lighting: reads what lighting reads and writes one target; nothing else.
#extension GL_GOOGLE_include_directive : require
#include "lib/gbuffer.glsl"

layout(constant_id = 0) const uint visibility_layers = 0;
layout(PASS_IMAGE(5)) uniform texture2DArray visibility; // where there are layers
layout(location = 0) out vec4 out_radiance;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
    uvec2 normals = texelFetch(gbuffer_normal, pixel, 0).xy;
    uint id = texelFetch(gbuffer_id, pixel, 0).x;
    uint emission = texelFetch(gbuffer_emission, pixel, 0).x;
    float depth = texelFetch(gbuffer_depth, pixel, 0).x;
    float seen = 0.0;
    for (uint i = 0u; i < visibility_layers; ++i) seen += texelFetch(visibility, ivec3(pixel, i), 0).x;
    out_radiance = albedo + vec4(uintBitsToFloat(normals), depth + seen, uintBitsToFloat(id ^ emission));
}
