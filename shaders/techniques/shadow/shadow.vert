#version 460
// Casters without holes: depth alone.
#extension GL_GOOGLE_include_directive : require
#include "techniques/shadow/shadow_position.glsl"

layout(location = 0) in vec3 position;

void main() { gl_Position = shadow_position(position); }
