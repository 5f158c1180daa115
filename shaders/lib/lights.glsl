// Light reaching a point: falloff and cones here, the areas of rectangles in ltc.glsl. Source: Karis 2013 (windowed
// inverse square); Lagarde & de Rousiers 2014.
#ifndef LIGHTS_GLSL
#define LIGHTS_GLSL
#include "lib/brdf.glsl"
#include "lib/frame.glsl"
#include "lib/ltc.glsl"

float square(float x) { return x * x; }

/// Irradiance on a surface that faces the light, and the direction to it. Sun, spot and point by one formula, without a
/// branch: a sun stands at distance 1 in every place, has no range and no cone.
float light_falloff(GpuLight light, vec3 p, out vec3 l)
{
    vec3 d = light.position - light.local * p;
    float d2 = max(dot(d, d), 1e-4); // closer than 1 cm counts as 1 cm
    l = d * inversesqrt(d2);
    float window = square(clamp(1.0 - square(d2 * light.inv_range2), 0.0, 1.0));
    float cone = square(clamp(light.spot_offset - dot(l, light.direction) * light.spot_scale, 0.0, 1.0));
    return window * cone / d2;
}

/// A rectangle in the axes of a surface that is seen from v.
LocalRect local_rect(GpuLight light, vec3 p, vec3 n, vec3 v)
{
    vec3 away = n * dot(n, v) - v;
    // Seen from straight above, any axis will do.
    if (dot(away, away) < 1e-8) away = abs(n.x) < 0.5 ? cross(n, vec3(1.0, 0.0, 0.0)) : cross(n, vec3(0.0, 1.0, 0.0));
    vec3 x = normalize(away);
    mat3 local = transpose(mat3(x, cross(n, x), n));
    return LocalRect(local * (light.position - p), local * light.half_right, local * light.half_up);
}

/// Light of a sun, spot or point light that leaves p towards the eye, radiance x exposure.
vec3 shade_delta(GpuLight light, vec3 p, vec3 n, vec3 v, Brdf b)
{
    vec3 l;
    float falloff = light_falloff(light, p, l);
    float n_l = dot(n, l);
    if (n_l <= 0.0 || falloff <= 0.0) return vec3(0.0);
    return light.color * (falloff * n_l) * brdf_evaluate(b, n_l, dot(v, l));
}

/// The same of a rectangle.
vec3 shade_rect(GpuLight light, vec3 p, vec3 n, vec3 v, Brdf b)
{
    if (dot(light.position - p, light.direction) >= 0.0) return vec3(0.0); // behind its one side
    LocalRect rect = local_rect(light, p, n, v);
    ClippedRect clipped = clip_at_horizon(rect);
    vec3 diffuse = b.diffuse * (brdf_pi * form_factor(clipped));
    return light.color * (diffuse + brdf_specular_sum(b, rect_specular(rect, clipped, b)));
}

/// Whether a light reaches p at all: range, cone, the front of a rectangle.
bool light_reaches(GpuLight light, vec3 p)
{
    if (light.type == light_rect) return dot(light.position - p, light.direction) < 0.0;
    vec3 l;
    return light_falloff(light, p, l) > 0.0;
}

#endif
