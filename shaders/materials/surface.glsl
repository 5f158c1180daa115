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

vec4 sample_material_lod0(uint slot, uint sampler_slot, vec2 uv)
{
    return textureLod(sampler2D(textures[nonuniformEXT(slot)], samplers[nonuniformEXT(sampler_slot)]), uv, 0.0);
}

/// Base colour and opacity, from which masks are cut.
vec4 sample_base_color(Material m, vec2 uv)
{
    vec4 color = vec4(m.base_color, m.opacity);
    if (m.base_color_slot != no_texture_slot) color *= sample_material(m.base_color_slot, m.sampler_slot, uv);
    return color;
}

/// Opacity for the mask's test. With debug.alpha_lod0 it is read from mip 0, as a ray tracer would.
float mask_opacity(Material m, vec2 uv, float filtered)
{
    if ((frame.flags & flag_alpha_lod0) == 0u || m.base_color_slot == no_texture_slot) return filtered;
    return m.opacity * sample_material_lod0(m.base_color_slot, m.sampler_slot, uv).a;
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
