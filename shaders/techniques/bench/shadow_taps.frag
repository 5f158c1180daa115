#version 460
// floor.shadow_taps: as many depths as soft shadows read and compare at a pixel, over the same kind of reach, and the
// write.
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/pass.glsl"
#include "lib/textures.glsl"

layout(constant_id = 0) const uint plain_taps = 16;
layout(constant_id = 1) const uint compared_taps = 32;
layout(PASS_IMAGE(0)) uniform texture2D map;
layout(location = 0) out float out_sum;

vec2 spot(uint i)
{
    vec2 offset = vec2((int(i) * 7) % 33 - 16, (int(i) * 13) % 33 - 16);
    return (gl_FragCoord.xy + offset) * frame.inv_size;
}

void main()
{
    float sum = 0.0;
    for (uint i = 0u; i < plain_taps; ++i)
        sum += textureLod(sampler2D(map, samplers[sampler_nearest_clamp]), spot(i), 0.0).x;
    for (uint i = 0u; i < compared_taps; ++i)
        sum += textureLod(sampler2DShadow(map, comparison_samplers[sampler_shadow]), vec3(spot(i), 0.5), 0.0);
    out_sum = sum;
}
