// Keeps the triangles that can cover a pixel and are not hidden by the depth drawn so far. After cull_triangles.glsl;
// PYRAMID_LEVELS: where the push constants have the pyramid's levels.
#define PYRAMID_BUFFER 2
#include "techniques/culling/depth_pyramid.glsl"

bool keep_triangle(uint instances, ScreenTriangle t)
{
    if (!t.covers || t.crosses || instances != instances_of_partly_hidden) return t.covers;
    return occlusion(PYRAMID_LEVELS, t.low, t.high, t.nearest, t.nearest) != hides_all;
}
