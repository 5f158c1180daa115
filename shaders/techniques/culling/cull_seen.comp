#version 460
// First half of occlusion culling: draws what was seen in the frame before, where it is in the view still.
#extension GL_GOOGLE_include_directive : require
#include "techniques/culling/culling.glsl"

layout(PASS_BUFFER(1), scalar) readonly buffer Seen { uint seen[]; }; // by task
layout(push_constant, scalar) uniform Push { CullPush push; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= push.count) return;
    DrawTask task = task_table[order_table[i]];
    write_command(i, task, seen[order_table[i]] != 0u && may_be_seen(task, sphere_of(task), push.flags));
}
