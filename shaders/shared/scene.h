// The scene's tables in device memory.
#ifndef SHARED_SCENE_H
#define SHARED_SCENE_H
#include "types.h"
SHARED_BEGIN

const uint no_texture_slot = 0xffffu;

// In GpuMaterial::flags, above the 24 bits of a record.
const uint material_clamps = 0x1000000u; // textures clamp to edge instead of repeating
const uint material_emits = 0x2000000u;

struct GpuMaterial {
    uvec4 factors; // pairs of halves: base colour rg; b, opacity; perceptual roughness, metallic; dielectric F0, alpha cutoff
    uvec2 slots;   // 16-bit slots of the texture table, or no_texture_slot: base colour | normal << 16, surface | emission << 16
    uint flags;
    vec3 emission; // radiance
};

const uint record_moves = 1; // prev_from_object differs from world_from_object
const uint record_two_sided = 2;
const uint record_has_holes = 4; // fragments may be discarded
const uint record_deformed = 8;  // the vertex function moves its vertices, in each frame differently

/// One mesh of one instance: what a draw's first instance index points to.
struct GpuRecord {
    vec4 world_rows[3];    // rows of world_from_object
    vec4 prev_rows[3];     // the same one frame earlier
    uint material;
    uint mesh;
    uint instance;
    uint flags;
    float max_scale;       // largest scale of world_from_object, for bounding spheres
    int vertex_offset;     // of its bake's vertices in the common buffer
};

/// Bounds of a run of triangles, in object space; see atrium::Cluster for the cone's rule.
struct GpuCluster {
    vec3 centre;
    float radius;
    vec3 cone_axis;
    float cone_cutoff;
    uint first_index;
    uint index_count;
};

SHARED_END
#ifdef __cplusplus
static_assert(sizeof(atrium::shared::GpuMaterial) == 40);
static_assert(sizeof(atrium::shared::GpuRecord) == 120);
static_assert(sizeof(atrium::shared::GpuCluster) == 40);
#endif
#endif
