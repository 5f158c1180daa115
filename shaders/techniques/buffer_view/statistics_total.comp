#version 460
// Statistics of all tiles, by one group, and the range to show.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "techniques/buffer_view/statistics.glsl"

layout(local_size_x = statistics_group_size) in;
layout(PASS_BUFFER(0), scalar) readonly buffer Tiles { BufferStatistics tiles[]; };
layout(PASS_BUFFER(1), scalar) writeonly buffer Total { BufferStatistics total; };
layout(push_constant, scalar) uniform Push { BufferStatisticsPush push; };
shared BufferStatistics parts[statistics_group_size];

vec2 range_of(BufferStatistics all)
{
    vec2 range = push.range;
    if (push.fitted != 0u) range = all.count > 0u ? vec2(all.low, all.high) : vec2(0.0, 1.0);
    if (range.x == range.y) range.y += max(abs(range.x), 1.0);
    return range;
}

void main()
{
    uint own = gl_LocalInvocationIndex;
    parts[own] = no_statistics();
    for (uint i = own; i < push.tiles; i += statistics_group_size) parts[own] = combined(parts[own], tiles[i]);
    for (uint half_size = statistics_group_size / 2u; half_size > 0u; half_size /= 2u) {
        barrier();
        if (own < half_size) parts[own] = combined(parts[own], parts[own + half_size]);
    }
    if (own > 0u) return;
    total = parts[0];
    total.range = range_of(parts[0]);
}
