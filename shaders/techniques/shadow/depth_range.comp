#version 460
// A further level of the depth ranges, from the one before.
#extension GL_GOOGLE_include_directive : require
#include "lib/dispatch.glsl"
#include "techniques/shadow/depth_range.glsl"

layout(local_size_x = shadow_group_size) in;
layout(PASS_BUFFER(0), scalar) buffer Ranges { vec2 ranges[]; };
layout(push_constant, scalar) uniform Push { DepthRangePush push; };

void main()
{
    uint side = push.cells >> push.level, per_face = side * side;
    uint i = INVOCATION_INDEX;
    if (i >= push.faces * per_face) return;
    uint face = i / per_face;
    uvec2 cell = uvec2(i % side, i % per_face / side);
    vec2 range = nothing_there;
    for (uint k = 0u; k < 4u; ++k) {
        vec2 part = ranges[cell_index(push.cells, push.faces, push.level - 1u, face, 2u * cell + uvec2(k & 1u, k >> 1))];
        range = vec2(max(range.x, part.x), min(range.y, part.y));
    }
    ranges[cell_index(push.cells, push.faces, push.level, face, cell)] = range;
}
