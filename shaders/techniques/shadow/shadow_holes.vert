#version 460
// Casters whose fragments may be discarded.
#extension GL_GOOGLE_include_directive : require
#include "techniques/shadow/shadow_position.glsl"

layout(location = 0) out vec2 v_uv;
layout(location = 1) flat out uint v_record;

void main()
{
    v_uv = uv;
    v_record = gl_BaseInstance;
    gl_Position = shadow_position(world_position(gl_BaseInstance, fetch_vertex()));
}
