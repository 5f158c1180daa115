#version 460
// Occluders: what is in the view, has no holes and is made of large triangles.
#extension GL_GOOGLE_include_directive : require
#include "techniques/culling/culling.glsl"

layout(push_constant, scalar) uniform Push { CullPush push; };

void main()
{
    uint i = INVOCATION_INDEX;
    if (i >= push.count) return;
    DrawTask task = task_table[order_table[i]];
    ClusterSphere s = sphere_of(task);
    write_command(i, task, is_occluder(task, s) && may_be_seen(task, s, push.flags) ? 1u : 0u);
}
