#version 460
// Keeps the triangles that can be seen past the depth of those that the frame before saw: all of them for the next frame,
// and apart those that this one has not drawn yet.
#extension GL_GOOGLE_include_directive : require
#define REMEMBERS
#include "shared/culling.h"
layout(push_constant, scalar) uniform Push { SeenPush push; };
#include "techniques/culling/cull_triangles.glsl"

uint task_count() { return push.occlusion.cull.count; }
#define PYRAMID_LEVELS push.occlusion.levels
#include "techniques/culling/keep_visible.glsl"
