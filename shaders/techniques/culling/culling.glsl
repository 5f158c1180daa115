// One thread per cluster in draw order: the tests that need no other cluster's depth, and the command that comes of them.
#include "lib/dispatch.glsl"
#include "lib/pass.glsl"
#include "lib/scene.glsl"
#include "shared/culling.h"
#include "techniques/culling/cluster_sphere.glsl"

layout(local_size_x = cull_group_size) in;
layout(set = 1, binding = 4, scalar) readonly buffer TaskTable { DrawTask task_table[]; };
layout(set = 1, binding = 5, scalar) readonly buffer OrderTable { uint order_table[]; };
layout(PASS_BUFFER(0), scalar) writeonly buffer Commands { DrawCommand commands[]; };

/// Against the four sides and the near plane; there is no far plane.
bool outside_frustum(ClusterSphere s)
{
    float z = dot(s.d, frame.forward);
    vec2 tangent = vec2(frame.tan_x, frame.tan_y);
    vec2 side = abs(vec2(dot(s.d, frame.right), dot(s.d, frame.up)) + z * tangent * frame.jitter);
    return z + s.radius < frame.near || any(greaterThan(side - z * tangent, s.radius * sqrt(1.0 + tangent * tangent)));
}

bool faces_away(DrawTask task, ClusterSphere s)
{
    GpuCluster cluster = cluster_table[task.cluster];
    bool has_cone = (record_table[task.record].flags & (record_two_sided | record_deformed)) == 0u;
    if (!has_cone || cluster.cone_cutoff >= 1.0) return false;
    vec3 axis = normalize(transform_vector(record_table[task.record].world_rows, cluster.cone_axis));
    return dot(s.d, axis) >= cluster.cone_cutoff * length(s.d) + s.radius;
}

bool may_be_seen(DrawTask task, ClusterSphere s, uint flags)
{
    if ((flags & cull_frustum) != 0u && outside_frustum(s)) return false;
    return (flags & cull_cone) == 0u || !faces_away(task, s);
}

/// Commands keep their place, so the picture never depends on the order in which threads ran.
void write_command(uint i, DrawTask task, uint instances)
{
    commands[i] = DrawCommand(cluster_table[task.cluster].index_count, instances,
                              cluster_table[task.cluster].first_index, record_table[task.record].vertex_offset,
                              task.record);
}
