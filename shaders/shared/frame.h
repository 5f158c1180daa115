// Constants of one frame: the uniform buffer of set 1.
#ifndef SHARED_FRAME_H
#define SHARED_FRAME_H
#include "types.h"
#include "light.h"
SHARED_BEGIN

const uint flag_normal_mapping = 1, flag_specular_mapping = 2, flag_alpha_lod0 = 4;

struct FrameConstants {
    mat4 clip_from_world;      // reversed infinite depth, with this frame's jitter
    mat4 prev_clip_from_world; // of the camera in the frame before, with the same jitter
    vec3 eye;                  // m, world
    float near;                // m; depth = near / distance along the view axis
    vec3 right;                // unit camera axes in the world
    float tan_x;               // tangent of half the horizontal field of view
    vec3 up;
    float tan_y;
    vec3 ray_forward;          // forward with the jitter taken off: the ray through the middle of the picture
    float exposure;            // colour buffers hold luminance x this
    vec2 size;                 // pixels
    vec2 inv_size;
    vec3 ambient_sky;          // radiance x exposure x intensity
    uint light_count;
    vec3 ambient_ground;
    uint flags;
    vec3 sky_zenith;           // radiance x exposure
    vec3 sky_horizon;
    vec3 sky_ground;
    GpuLight lights[light_capacity];
    vec3 forward;              // unit
    vec2 jitter;               // contained in both matrices; normalised device coordinates
    vec2 corner;               // upper left of the picture in normalised device coordinates without jitter
};

SHARED_END
#ifdef __cplusplus
static_assert(offsetof(atrium::shared::FrameConstants, eye) == 128 && offsetof(atrium::shared::FrameConstants, size) == 192);
static_assert(offsetof(atrium::shared::FrameConstants, lights) == 276);
#endif
#endif
