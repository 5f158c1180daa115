#version 460
// One subgroup per draw command: copies the indices of those of its triangles that can cover a pixel, in their order,
// and makes the command draw the copy.
// Source: Wihlidal 2016, "Optimizing the Graphics Pipeline with Compute", GDC.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require
#include "lib/pass.glsl"
#include "lib/scene.glsl"
#include "shared/culling.h"

layout(local_size_x_id = 0) in; // a subgroup
layout(set = 1, binding = 4, scalar) readonly buffer TaskTable { DrawTask task_table[]; };
layout(set = 1, binding = 5, scalar) readonly buffer OrderTable { uint order_table[]; };
layout(set = 1, binding = 6, scalar) readonly buffer VertexTable { PackedVertex vertex_table[]; };
layout(set = 1, binding = 7, scalar) readonly buffer IndexTable { uint index_table[]; };
layout(PASS_BUFFER(0), scalar) buffer Commands { DrawCommand commands[]; };
layout(PASS_BUFFER(1), scalar) writeonly buffer Kept { uint kept_indices[]; };

// Rasterisers round positions to at least 1/16 of a pixel (VkPhysicalDeviceLimits::subPixelPrecisionBits >= 4): what
// comes nearer than that to covering a pixel is kept.
const float snap = 1.0 / 16.0;

vec3 clip_position(vec4 rows[3], uint vertex) // x, y, w
{
    return (frame.clip_from_world * vec4(transform_point(rows, vertex_table[vertex].position), 1)).xyw;
}

bool can_cover_a_pixel(vec3 a, vec3 b, vec3 c, bool one_sided)
{
    vec3 x = vec3(a.x, b.x, c.x), y = vec3(a.y, b.y, c.y), w = vec3(a.z, b.z, c.z);
    if (all(greaterThan(x, w)) || all(greaterThan(-x, w)) || all(greaterThan(y, w)) || all(greaterThan(-y, w)) ||
        all(lessThan(w, vec3(frame.near)))) {
        return false;
    }
    if (any(lessThan(w, vec3(frame.near)))) return true; // to be clipped
    vec2 p = (a.xy / a.z * 0.5 + 0.5) * frame.size, q = (b.xy / b.z * 0.5 + 0.5) * frame.size,
         r = (c.xy / c.z * 0.5 + 0.5) * frame.size;
    // No centre of a pixel (at .5) between the least and the greatest coordinate.
    vec2 low = min(p, min(q, r)) - snap, high = max(p, max(q, r)) + snap;
    if (any(equal(floor(low + 0.5), floor(high + 0.5)))) return false;
    if (!one_sided) return true;
    vec2 e = q - p, f = r - p;
    return e.x * f.y - e.y * f.x > -2.0 * snap * (abs(e.x) + abs(e.y) + abs(f.x) + abs(f.y));
}

void main()
{
    uint i = gl_WorkGroupID.x;
    if (gl_SubgroupID > 0u || commands[i].instance_count == 0u) return;
    DrawTask task = task_table[order_table[i]];
    GpuCluster cluster = cluster_table[task.cluster];
    vec4 rows[3] = record_table[task.record].world_rows;
    uint vertex_offset = uint(record_table[task.record].vertex_offset);
    bool one_sided = (record_table[task.record].flags & record_two_sided) == 0u;

    uint kept = 0u;
    for (uint first = 0u; first < cluster.index_count; first += 3u * gl_SubgroupSize) {
        uint index = first + 3u * gl_SubgroupInvocationID;
        bool keep = false;
        uvec3 corners = uvec3(0u);
        if (index < cluster.index_count) {
            uint at = cluster.first_index + index;
            corners = uvec3(index_table[at], index_table[at + 1u], index_table[at + 2u]);
            keep = can_cover_a_pixel(clip_position(rows, vertex_offset + corners.x),
                                     clip_position(rows, vertex_offset + corners.y),
                                     clip_position(rows, vertex_offset + corners.z), one_sided);
        }
        uvec4 ballot = subgroupBallot(keep);
        if (keep) {
            uint to = task.slot + kept + 3u * subgroupBallotExclusiveBitCount(ballot);
            kept_indices[to] = corners.x;
            kept_indices[to + 1u] = corners.y;
            kept_indices[to + 2u] = corners.z;
        }
        kept += 3u * subgroupBallotBitCount(ballot);
    }
    if (subgroupElect()) {
        commands[i].first_index = task.slot;
        commands[i].index_count = kept;
        commands[i].instance_count = kept > 0u ? 1u : 0u;
    }
}
