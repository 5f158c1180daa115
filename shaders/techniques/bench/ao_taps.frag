#version 460
// floor.ao_taps: as many depths as ambient occlusion reads at a pixel, over the same reach, and the write.
#extension GL_GOOGLE_include_directive : require
#include "lib/depth_normal.glsl"
#include "lib/frame.glsl"

layout(constant_id = 0) const uint taps = 18;
layout(location = 0) out vec2 out_sum;

void main()
{
    ivec2 last = ivec2(frame.size) - 1;
    float sum = 0.0;
    for (uint i = 0u; i < taps; ++i) {
        ivec2 offset = ivec2((int(i) * 7) % 33 - 16, (int(i) * 13) % 33 - 16);
        sum += fetch_depth(clamp(ivec2(gl_FragCoord.xy) + offset, ivec2(0), last));
    }
    out_sum = vec2(sum);
}
