#version 460
// Depth alone: the position must come out as in gbuffer.vert, to the bit.
#extension GL_GOOGLE_include_directive : require
#include "lib/scene.glsl"

layout(location = 0) in vec3 position;

invariant gl_Position;

void main()
{
    vec3 world = transform_point(record_table[gl_BaseInstance].world_rows, position);
    gl_Position = frame.clip_from_world * vec4(world, 1);
}
