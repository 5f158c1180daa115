// Positions of the scene's vertices, for every pass that draws the scene: they are bit for bit the same in all of them, so
// that one pass can test against the depth that another wrote.
#ifndef POSITION_GLSL
#define POSITION_GLSL
#include "lib/scene.glsl"
#include "shared/material_class.h"

// The vertex function of the drawn material class: column `vertex` of renderer/materials/material_class.hpp.
layout(constant_id = 1) const uint vertex_function = vertex_rigid;

/// A vertex in object space.
struct ObjectVertex {
    vec3 position;
    vec3 normal;
    vec4 tangent; // w: handedness
    vec2 uv;
};

/// The class's vertex function: the vertex in this frame or, with `previous`, in the one before. One case per function.
ObjectVertex shape_vertex(ObjectVertex baked, bool previous) { return baked; }

/// World position in this frame, m.
vec3 world_position(uint record, ObjectVertex baked)
{
    return transform_point(record_table[record].world_rows, shape_vertex(baked, false).position);
}

/// World position one frame before, m.
vec3 previous_world_position(uint record, ObjectVertex baked)
{
    return transform_point(record_table[record].prev_rows, shape_vertex(baked, true).position);
}

vec4 clip_position(vec3 world) { return frame.clip_from_world * vec4(world, 1); }

#endif
