#version 460
// Occluders: what is in the view, has no holes and is made of large triangles.
#extension GL_GOOGLE_include_directive : require
#include "techniques/culling/culling.glsl"

layout(push_constant, scalar) uniform Push { CullPush push; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= push.count) return;
    DrawTask task = task_table[order_table[i]];
    ClusterSphere s = sphere_of(task);
    float triangles = float(cluster_table[task.cluster].index_count) / 3.0;
    bool large = s.radius * s.radius > occluder_angle2 * triangles * dot(s.d, s.d);
    bool closed = (record_table[task.record].flags & record_has_holes) == 0u;
    write_command(i, task, large && closed && may_be_seen(task, s, push.flags) ? 1u : 0u);
}
