#version 460
// Ends of edges, a thousandth nearer than the surface that hides what is behind it.
#extension GL_GOOGLE_include_directive : require
#include "materials/vertex.glsl"

void main()
{
    gl_Position = clip_position(world_position(gl_BaseInstance, fetch_vertex()));
    gl_Position.z *= 1.001; // reversed depth
}
