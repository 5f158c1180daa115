#version 460
// Casters without holes: depth alone.
#extension GL_GOOGLE_include_directive : require
#include "techniques/shadow/shadow_position.glsl"

void main() { gl_Position = shadow_position(world_position(gl_BaseInstance, fetch_vertex())); }
