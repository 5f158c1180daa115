#version 460
// Vertices of the scene into clip space, with what the surface functions need.
#extension GL_GOOGLE_include_directive : require
#include "materials/vertex.glsl"

// Few and full varyings: a CPU device pays for each by vertex, by triangle and by block of pixels.
layout(location = 0) out vec4 v_offset_u;  // from the eye, m, world: small numbers keep derivatives exact; u
layout(location = 1) out vec4 v_normal_v;  // normal, v
layout(location = 2) out vec4 v_tangent;
layout(location = 3) out vec3 v_prev_clip; // x, y, w one frame earlier
// The material travels with the vertices: on a CPU device a fragment's look-up in a table costs eight scalar loads a
// word, a constant varying nothing.
layout(location = 4) flat out uvec4 v_factors;
layout(location = 5) flat out uvec3 v_slots; // slots, flags and record

void main()
{
    uint index = gl_BaseInstance; // one instance a draw: uniform, which the device can know
    vec4 rows[3] = record_table[index].world_rows;
    ObjectVertex baked = fetch_vertex(), shaped = shape_vertex(baked, false);
    vec3 world = world_position(index, baked);
    vec3 previous = world;
    if ((record_table[index].flags & record_moves) != 0u) previous = previous_world_position(index, baked);

    v_offset_u = vec4(world - frame.eye, uv.x);
    v_normal_v = vec4(transform_vector(rows, shaped.normal), uv.y);
    v_tangent = vec4(transform_vector(rows, shaped.tangent.xyz), shaped.tangent.w);
    v_prev_clip = (frame.prev_clip_from_world * vec4(previous, 1)).xyw;
    uint material = record_table[index].material;
    v_factors = material_table[material].factors;
    v_slots = uvec3(material_table[material].slots, material_table[material].flags | index);
    gl_Position = clip_position(world);
}
