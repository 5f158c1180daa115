#version 460
// Level 0 of the depth ranges, from the map.
#extension GL_GOOGLE_include_directive : require
#include "lib/dispatch.glsl"
#include "lib/textures.glsl"
#include "techniques/shadow/depth_range.glsl"

layout(local_size_x = shadow_group_size) in;
layout(PASS_IMAGE(0)) uniform texture2D map;
layout(PASS_BUFFER(0), scalar) writeonly buffer Ranges { vec2 ranges[]; };
layout(push_constant, scalar) uniform Push { DepthRangePush push; };

void main()
{
    uint i = INVOCATION_INDEX, per_face = push.cells * push.cells;
    if (i >= push.faces * per_face) return;
    uint face = i / per_face;
    uvec2 cell = uvec2(i % push.cells, i % per_face / push.cells), from = cell * shadow_cell;
    vec2 texel = 1.0 / vec2(push.side * push.faces, push.side);
    vec2 range = nothing_there;
    for (uint k = 0u; k < shadow_cell * shadow_cell / 4u; ++k) { // four texels at a time
        uvec2 corner = min(from + 2u * uvec2(k % (shadow_cell / 2u), k / (shadow_cell / 2u)), uvec2(push.side - 2u));
        vec2 uv = (vec2(corner.x + face * push.side, corner.y) + 1.0) * texel;
        vec4 d = textureGather(sampler2D(map, samplers[sampler_nearest_clamp]), uv);
        range = vec2(max(range.x, max(max(d.x, d.y), max(d.z, d.w))), min(range.y, min(min(d.x, d.y), min(d.z, d.w))));
    }
    if (any(greaterThanEqual(from, uvec2(push.side)))) range = nothing_there;
    ranges[cell_index(push.cells, push.faces, 0u, face, cell)] = range;
}
