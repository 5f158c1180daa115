#version 460
// Keeps the triangles that can cover a pixel and are not hidden by the occluders.
#extension GL_GOOGLE_include_directive : require
#include "techniques/culling/cull_triangles.glsl"

#define PYRAMID_BUFFER 2
#include "techniques/culling/depth_pyramid.glsl"

layout(push_constant, scalar) uniform Push { OcclusionPush push; };

bool keep_triangle(uint instances, ScreenTriangle t)
{
    if (!t.covers || t.crosses || instances != instances_of_partly_hidden) return t.covers;
    return occlusion(push.levels, t.low, t.high, t.nearest, t.nearest) != hides_all;
}
