// The scene's tables: set 1 beside the frame's constants.
#ifndef SCENE_GLSL
#define SCENE_GLSL
#include "lib/frame.glsl"
#include "shared/scene.h"

layout(set = 1, binding = 1, scalar) readonly buffer MaterialTable { GpuMaterial material_table[]; };
layout(set = 1, binding = 2, scalar) readonly buffer RecordTable { GpuRecord record_table[]; };
layout(set = 1, binding = 3, scalar) readonly buffer ClusterTable { GpuCluster cluster_table[]; };

/// A material's fields, unpacked.
struct Material {
    vec3 base_color;
    float opacity;
    float roughness, metallic; // perceptual roughness
    float specular;            // dielectric F0
    float alpha_cutoff;
    vec3 emission;             // radiance
    uint sampler_slot;
    uint base_color_slot, normal_slot, surface_slot, emission_slot; // or no_texture_slot
};

/// `factors`, `slots` and `flags` of a GpuMaterial; the record in the low bits of `flags`.
Material unpack_material(uvec4 factors, uvec2 slots, uint flags)
{
    Material m;
    vec2 blue_opacity = unpackHalf2x16(factors.y), surface = unpackHalf2x16(factors.z), rest = unpackHalf2x16(factors.w);
    m.base_color = vec3(unpackHalf2x16(factors.x), blue_opacity.x);
    m.opacity = blue_opacity.y;
    m.roughness = surface.x;
    m.metallic = surface.y;
    m.specular = rest.x;
    m.alpha_cutoff = rest.y;
    m.base_color_slot = slots.x & 0xffffu;
    m.normal_slot = slots.x >> 16;
    m.surface_slot = slots.y & 0xffffu;
    m.emission_slot = slots.y >> 16;
    m.emission = vec3(0.0);
    if ((flags & material_emits) != 0u) m.emission = material_table[record_table[flags & 0xffffffu].material].emission;
    m.sampler_slot = (flags & material_clamps) != 0u ? 1u : 0u; // sampler_material_clamp, sampler_material
    return m;
}

vec3 transform_point(vec4 rows[3], vec3 p) { return vec3(dot(rows[0], vec4(p, 1)), dot(rows[1], vec4(p, 1)), dot(rows[2], vec4(p, 1))); }
vec3 transform_vector(vec4 rows[3], vec3 v) { return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v)); }

#endif
