#version 460
// Draws into a face of a shadow map what may cast a shadow that is seen in it. Nothing is left out for the way it faces.
#extension GL_GOOGLE_include_directive : require
#include "lib/dispatch.glsl"
#include "lib/pass.glsl"
#include "lib/scene.glsl"
#include "shared/culling.h"
#include "shared/shadow.h"

layout(local_size_x = shadow_group_size) in;
layout(set = 1, binding = 4, scalar) readonly buffer TaskTable { DrawTask task_table[]; };
layout(set = 1, binding = 5, scalar) readonly buffer OrderTable { uint order_table[]; };
layout(PASS_BUFFER(0), scalar) writeonly buffer Commands { DrawCommand commands[]; };
layout(push_constant, scalar) uniform Push { ShadowCullPush push; };

bool may_cast(vec3 centre, float radius)
{
    ShadowFace f = push.face;
    vec4 c = vec4(centre, 1.0);
    vec2 at = vec2(dot(f.x, c), dot(f.y, c));
    if (push.perspective == 0u) return all(lessThan(abs(at), vec2(1.0 + radius / f.scale)));
    float z = dot(f.z, c);
    if (z + radius < 0.0 || (push.range > 0.0 && z - radius > push.range)) return false;
    return all(lessThan(abs(at), vec2(z + radius * sqrt(1.0 + 1.0 / (f.scale * f.scale)))));
}

void main()
{
    uint i = INVOCATION_INDEX;
    if (i >= push.count) return;
    DrawTask task = task_table[order_table[i]];
    GpuCluster cluster = cluster_table[task.cluster];
    vec3 centre = transform_point(record_table[task.record].world_rows, cluster.centre);
    float radius = cluster.radius * record_table[task.record].max_scale + push.extent;
    commands[push.first + i] = DrawCommand(cluster.index_count, may_cast(centre, radius) ? 1u : 0u, cluster.first_index,
                                           record_table[task.record].vertex_offset, task.record);
}
