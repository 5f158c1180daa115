#version 460
// Statistics of each tile of a buffer, one thread a tile.
#extension GL_GOOGLE_include_directive : require
#include "lib/dispatch.glsl"
#include "lib/pass.glsl"
#include "techniques/buffer_view/picked.glsl"
#include "techniques/buffer_view/statistics.glsl"

layout(local_size_x = statistics_group_size) in;
layout(PASS_IMAGE(0)) uniform texture2D source;
layout(PASS_BUFFER(0), scalar) writeonly buffer Tiles { BufferStatistics tiles[]; };
layout(push_constant, scalar) uniform Push { BufferStatisticsPush push; };

void main()
{
    uint tile = INVOCATION_INDEX;
    if (tile >= push.tiles) return;
    uvec2 size = uvec2(textureSize(source, 0));
    uint across = (size.x + statistics_tile - 1u) / statistics_tile;
    uvec2 from = uvec2(tile % across, tile / across) * statistics_tile;
    uvec2 to = min(from + statistics_tile, size);
    uint count = push.pick == pick_all ? push.channels : 1u;
    BufferStatistics all = no_statistics();
    for (uint y = from.y; y < to.y; ++y) {
        for (uint x = from.x; x < to.x; ++x) {
            vec3 values = picked(texelFetch(source, ivec2(x, y), 0), push.pick);
            for (uint c = 0u; c < count; ++c) {
                float v = values[c];
                if (is_finite(v)) all = combined(all, BufferStatistics(v, v, v, 1u, vec2(0.0)));
            }
        }
    }
    tiles[tile] = all;
}
