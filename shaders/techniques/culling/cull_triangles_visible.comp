#version 460
// Keeps the triangles that can cover a pixel and are not hidden by the occluders.
#extension GL_GOOGLE_include_directive : require
#include "techniques/culling/cull_triangles.glsl"

layout(push_constant, scalar) uniform Push { OcclusionPush push; };
uint task_count() { return push.cull.count; }
#define PYRAMID_LEVELS push.levels
#include "techniques/culling/keep_visible.glsl"
