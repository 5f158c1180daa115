// What every material class starts from: the material's textures and factors at a point of a surface.
#ifndef SURFACE_GLSL
#define SURFACE_GLSL
#include "lib/scene.glsl"
#include "lib/textures.glsl"

/// Interpolated at a fragment.
struct SurfacePoint {
    vec3 normal;  // not normalised
    vec4 tangent; // xyz not normalised, w handedness
    vec2 uv;
    bool front;   // the side that the winding faces
};

struct SurfaceSample {
    vec3 base_color;
    float opacity;
    vec3 normal;  // unit, world
    float roughness, metallic, specular;
    vec3 emission;
};

// Whether fragments of several materials may run side by side in one group. On GPUs they may; a software rasteriser shades
// triangle by triangle, and need not look for differences (which costs it a fifth of the pass).
layout(constant_id = 0) const bool materials_diverge = true;

vec4 sample_material(uint slot, uint sampler_slot, vec2 uv)
{
    if (materials_diverge) return texture(sampler2D(textures[nonuniformEXT(slot)], samplers[nonuniformEXT(sampler_slot)]), uv);
    return texture(sampler2D(textures[slot], samplers[sampler_slot]), uv);
}

/// The same, so many mip levels further.
vec4 sample_material(uint slot, uint sampler_slot, vec2 uv, float bias)
{
    return texture(sampler2D(textures[nonuniformEXT(slot)], samplers[nonuniformEXT(sampler_slot)]), uv, bias);
}

vec4 sample_material_level(uint slot, uint sampler_slot, vec2 uv, float level)
{
    return textureLod(sampler2D(textures[nonuniformEXT(slot)], samplers[nonuniformEXT(sampler_slot)]), uv, level);
}

/// Base colour and opacity, from which masks are cut.
vec4 sample_base_color(Material m, vec2 uv)
{
    vec4 color = vec4(m.base_color, m.opacity);
    if (m.base_color_slot != no_texture_slot) color *= sample_material(m.base_color_slot, m.sampler_slot, uv);
    return color;
}

/// Mip level at which a mask is tested. The bake gives every level the covered area of the finest, so every level is right
/// on average. For an anisotropic footprint it is the level of the sides' geometric mean: averaging several samples along
/// the footprint would lose details thinner than its length. With debug.alpha_lod0 the finest level, as a ray tracer reads.
float mask_level(vec2 texels_dx, vec2 texels_dy, float bias)
{
    if ((frame.flags & flag_alpha_lod0) != 0u) return 0.0;
    float longest = max(dot(texels_dx, texels_dx), dot(texels_dy, texels_dy));
    float area = abs(texels_dx.x * texels_dy.y - texels_dx.y * texels_dy.x);
    return max(0.0, bias + 0.5 * max(log2(area), log2(longest) - 6.0)); // log of squared lengths: half of it is the level
}

/// Opacity for the mask test, and the mip level at which it was read.
vec2 mask_opacity(Material m, vec2 uv, float bias)
{
    if (m.base_color_slot == no_texture_slot) return vec2(m.opacity, 0.0);
    vec2 size = vec2(textureSize(sampler2D(textures[nonuniformEXT(m.base_color_slot)], samplers[nonuniformEXT(m.sampler_slot)]), 0));
    float level = mask_level(dFdx(uv) * size, dFdy(uv) * size, bias);
    return vec2(m.opacity * sample_material_level(m.base_color_slot, m.sampler_slot, uv, level).a, level);
}

/// Shading normal. Source: Mikkelsen 2008: unnormalised interpolants, bitangent from the handedness.
vec3 sample_normal(Material m, SurfacePoint p)
{
    vec3 n = normalize(p.normal);
    if (m.normal_slot != no_texture_slot && (frame.flags & flag_normal_mapping) != 0u) {
        vec2 xy = sample_material(m.normal_slot, m.sampler_slot, p.uv).xy * 2.0 - 1.0;
        float z = sqrt(max(0.0, 1.0 - dot(xy, xy)));
        vec3 bitangent = p.tangent.w * cross(p.normal, p.tangent.xyz);
        n = normalize(xy.x * p.tangent.xyz + xy.y * bitangent + z * p.normal);
    }
    return p.front ? n : -n;
}

/// Everything but the base colour, which the class has sampled already (masks are cut before the rest is paid for).
SurfaceSample sample_surface(Material m, SurfacePoint p, vec4 base_color)
{
    SurfaceSample s;
    s.base_color = base_color.rgb;
    s.opacity = base_color.a;
    s.normal = sample_normal(m, p);
    s.roughness = m.roughness;
    s.metallic = m.metallic;
    s.specular = m.specular;
    if (m.surface_slot != no_texture_slot && (frame.flags & flag_specular_mapping) != 0u) {
        vec3 surface = sample_material(m.surface_slot, m.sampler_slot, p.uv).rgb;
        s.specular *= surface.r;
        s.roughness *= surface.g;
        s.metallic *= surface.b;
    }
    s.emission = m.emission;
    if (m.emission_slot != no_texture_slot) s.emission *= sample_material(m.emission_slot, m.sampler_slot, p.uv).rgb;
    return s;
}

#endif
