#version 460
// Keeps the triangles that can cover a pixel.
#extension GL_GOOGLE_include_directive : require
#include "techniques/culling/cull_triangles.glsl"

layout(push_constant, scalar) uniform Push { CullPush push; };

uint task_count() { return push.count; }
bool keep_triangle(uint instances, ScreenTriangle t) { return t.covers; }
