#version 460
// Position only, for passes that write depth.
#extension GL_GOOGLE_include_directive : require
#include "materials/vertex.glsl"

void main() { gl_Position = clip_position(world_position(gl_BaseInstance, fetch_vertex())); }
