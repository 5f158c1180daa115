// Reading the G-buffer: the first five images of any pass that declared it (renderer/techniques/gbuffer/gbuffer.hpp).
#ifndef GBUFFER_GLSL
#define GBUFFER_GLSL
#include "lib/gbuffer_packing.glsl"
#include "lib/pass.glsl"

layout(PASS_IMAGE(0)) uniform texture2D gbuffer_albedo;    // base colour, metallic in alpha
layout(PASS_IMAGE(1)) uniform utexture2D gbuffer_normal;   // x shading normal; y geometric normal and roughness
layout(PASS_IMAGE(2)) uniform utexture2D gbuffer_id;       // record + 1 and dielectric F0
layout(PASS_IMAGE(3)) uniform utexture2D gbuffer_emission; // RGB9E5, radiance x exposure
layout(PASS_IMAGE(4)) uniform texture2D gbuffer_depth;     // reversed, infinite

/// What a pixel of the G-buffer says about its surface.
struct Surface {
    vec3 base_color;       // linear Rec.709
    float metallic;
    vec3 normal;           // unit, world, after normal mapping
    vec3 geometric_normal; // unit, world, towards the camera
    float roughness;       // perceptual
    float specular;        // dielectric F0
    uint record;           // index into the record table
};

uint fetch_id(ivec2 pixel) { return texelFetch(gbuffer_id, pixel, 0).x; }
float fetch_depth(ivec2 pixel) { return texelFetch(gbuffer_depth, pixel, 0).x; }

/// `id` is what fetch_id gave, and not background.
Surface fetch_surface(ivec2 pixel, uint id)
{
    vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
    uvec2 normals = texelFetch(gbuffer_normal, pixel, 0).xy;
    Surface s;
    s.base_color = albedo.rgb;
    s.metallic = albedo.a;
    s.normal = oct_unpack(normals.x, 16u);
    s.geometric_normal = oct_unpack(normals.y, 12u);
    s.roughness = float(normals.y >> 24) * (1.0 / 255.0);
    s.specular = unpack_specular(id & 255u);
    s.record = (id >> 8) - 1u;
    return s;
}

#endif
