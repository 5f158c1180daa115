#version 460
// Deferred lighting: every light of the range, ambient light and emission at each pixel of the G-buffer.
#extension GL_GOOGLE_include_directive : require
#include "lib/color.glsl"
#include "lib/gbuffer.glsl"
#include "lib/lights.glsl"
#include "shared/lighting.h"

// Lights without area that are known beforehand, from the first on: the compiler unrolls their loop, and their constants
// have fixed places (a CPU device reads those eight times faster). 0: the numbers in the push constants.
layout(constant_id = 0) const uint unrolled_lights = 0;
layout(push_constant, scalar) uniform Push { LightingPush push; };
layout(location = 0) out vec4 out_radiance;

/// Light from all around, coloured by the hemisphere: L = albedo (1 - metallic) ambient.
vec3 ambient_light(Surface s)
{
    vec3 ambient = mix(frame.ambient_ground, frame.ambient_sky, 0.5 + 0.5 * s.normal.y);
    return s.base_color * (1.0 - s.metallic) * ambient;
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
        for (uint i = 0u; i < unrolled_lights; ++i) sum += shade_delta(frame.lights[i], p, s.normal, v, b);
    } else {
        for (uint i = push.first_light; i < push.end_delta; ++i) sum += shade_delta(frame.lights[i], p, s.normal, v, b);
    }
    for (uint i = push.end_delta; i < push.end_light; ++i) sum += shade_rect(frame.lights[i], p, s.normal, v, b);
    if ((push.terms & term_ambient) != 0u) sum += ambient_light(s);
    if ((push.terms & term_emission) != 0u) sum += unpack_rgb9e5(texelFetch(gbuffer_emission, pixel, 0).x);
    out_radiance = vec4(sum * push.scale, 1.0);
}
