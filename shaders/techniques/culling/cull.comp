#version 460
// Draws what is in the view and does not face away.
#extension GL_GOOGLE_include_directive : require
#include "techniques/culling/culling.glsl"

layout(push_constant, scalar) uniform Push { CullPush push; };

void main()
{
    uint i = INVOCATION_INDEX;
    if (i >= push.count) return;
    DrawTask task = task_table[order_table[i]];
    write_command(i, task, may_be_seen(task, sphere_of(task), push.flags) ? 1u : 0u);
}
