#version 460
// Deferred lighting: every light of the range, ambient light and emission at each pixel of the G-buffer.
#extension GL_GOOGLE_include_directive : require
#include "lib/color.glsl"
#include "lib/gbuffer.glsl"
#include "lib/lights.glsl"
#include "shared/lighting.h"

// Number of lights without area, as a constant: the compiler unrolls their loop and reads them from fixed offsets (eight
// times faster on a CPU device). 0: the range in the push constants is used.
layout(constant_id = 0) const uint unrolled_lights = 0;
// Whether there are rectangle lights: frames without them leave out their long code.
layout(constant_id = 1) const bool rects = true;
// Whether to read ambient occlusion and visibility. If not, both are 1 everywhere.
layout(constant_id = 2) const bool occluded = true;
layout(constant_id = 3) const bool shadowed = true;
layout(push_constant, scalar) uniform Push { LightingPush push; };
layout(PASS_IMAGE(5)) uniform texture2D ao_image;
layout(PASS_IMAGE(6)) uniform texture2DArray visibility_images; // a layer for each light that casts shadows
layout(location = 0) out vec4 out_radiance;

/// Share of the ambient light that reaches a surface, by colour with multi-bounce: bright surfaces reflect light to each
/// other. Source: Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion".
vec3 ambient_reach(ivec2 pixel, vec3 albedo)
{
    if (!occluded) return vec3(1.0);
    float ao = min(texelFetch(ao_image, pixel, 0).x, 1.0);
    if ((push.terms & term_multi_bounce) == 0u) return vec3(ao);
    vec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    return max(vec3(ao), ((a * ao + b) * ao + c) * ao);
}

float visibility_of(uint layer, ivec2 pixel)
{
    if (!shadowed || layer == no_shadow_layer) return 1.0;
    return texelFetch(visibility_images, ivec3(pixel, layer), 0).x;
}

/// Reflected ambient light of the hemisphere: L = albedo (1 - metallic) ambient ao.
vec3 ambient_light(ivec2 pixel, Surface s)
{
    vec3 ambient = mix(frame.ambient_ground, frame.ambient_sky, 0.5 + 0.5 * s.normal.y);
    vec3 albedo = s.base_color * (1.0 - s.metallic);
    return albedo * ambient * ambient_reach(pixel, albedo);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint id = fetch_id(pixel);
    out_radiance = vec4(0.0);
    if (is_background(id)) return;

    Surface s = fetch_surface(pixel, id);
    vec3 ray = view_ray(gl_FragCoord.xy);
    vec3 p = frame.eye + ray * view_distance(fetch_depth(pixel));
    vec3 v = -normalize(ray);
    Brdf b = make_brdf(s.base_color, s.metallic, s.roughness, s.specular, dot(s.normal, v));

    vec3 sum = vec3(0.0);
    if (unrolled_lights > 0u) {
        for (uint i = 0u; i < unrolled_lights; ++i) {
            sum += shade_delta(frame.lights[i], p, s.normal, v, b) * visibility_of(frame.lights[i].shadow_layer, pixel);
        }
    } else {
        for (uint i = push.first_light; i < push.end_delta; ++i) {
            sum += shade_delta(frame.lights[i], p, s.normal, v, b) * visibility_of(frame.lights[i].shadow_layer, pixel);
        }
    }
    if (rects) {
        for (uint i = push.end_delta; i < push.end_light; ++i) {
            sum += shade_rect(frame.lights[i], p, s.normal, v, b) * visibility_of(frame.lights[i].shadow_layer, pixel);
        }
    }
    if ((push.terms & term_ambient) != 0u) sum += ambient_light(pixel, s);
    if ((push.terms & term_emission) != 0u) sum += unpack_rgb9e5(texelFetch(gbuffer_emission, pixel, 0).x);
    out_radiance = vec4(sum * push.scale, 1.0);
}
