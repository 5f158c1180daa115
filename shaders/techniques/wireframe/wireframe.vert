#version 460
// Ends of edges, a thousandth nearer than the surface that hides what is behind it.
#extension GL_GOOGLE_include_directive : require
#include "lib/scene.glsl"

layout(location = 0) in vec3 position;

void main()
{
    vec3 world = transform_point(record_table[gl_BaseInstance].world_rows, position);
    gl_Position = frame.clip_from_world * vec4(world, 1);
    gl_Position.z *= 1.001; // reversed depth
}
