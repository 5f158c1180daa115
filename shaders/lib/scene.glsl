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

Material unpack_material(GpuMaterial packed)
{
    Material m;
    m.base_color = packed.base.rgb;
    m.opacity = packed.base.a;
    m.roughness = packed.surface.x;
    m.metallic = packed.surface.y;
    m.specular = packed.surface.z;
    m.alpha_cutoff = packed.surface.w;
    m.base_color_slot = packed.slots.x & 0xffffu;
    m.normal_slot = packed.slots.x >> 16;
    m.surface_slot = packed.slots.y & 0xffffu;
    m.emission_slot = packed.slots.y >> 16;
    m.emission = vec3(0.0);
    if ((packed.slots.z | (packed.slots.w & 0xffffu)) != 0u) {
        m.emission = vec3(unpackHalf2x16(packed.slots.z), unpackHalf2x16(packed.slots.w & 0xffffu).x);
    }
    m.sampler_slot = (packed.slots.w & material_clamps) != 0u ? 1u : 0u; // sampler_material_clamp, sampler_material
    return m;
}

vec3 transform_point(vec4 rows[3], vec3 p) { return vec3(dot(rows[0], vec4(p, 1)), dot(rows[1], vec4(p, 1)), dot(rows[2], vec4(p, 1))); }
vec3 transform_vector(vec4 rows[3], vec3 v) { return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v)); }

#endif
