// Inputs of the vertex stage of every pass that draws the scene.
#ifndef VERTEX_GLSL
#define VERTEX_GLSL
#include "lib/octahedral.glsl"
#include "materials/position.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in uint packed_normal;
layout(location = 2) in uint packed_tangent;
layout(location = 3) in vec2 uv;

invariant gl_Position; // equal depths in all passes

ObjectVertex fetch_vertex()
{
    return ObjectVertex(position, oct_unpack(packed_normal, 16u), tangent_unpack(packed_tangent), uv);
}

#endif
