// Light reaching a point: falloff, cones and the areas of rectangles. Source: Karis 2013 (windowed inverse square);
// Lagarde & de Rousiers 2014; Baum et al. 1989 (irradiance of a polygon).
#ifndef LIGHTS_GLSL
#define LIGHTS_GLSL
#include "lib/brdf.glsl"
#include "lib/frame.glsl"

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

/// One edge of the polygon's irradiance integral: angle times the normal's share of its axis. atan: acos is coarse near 1.
float edge_integral(vec3 a, vec3 b, vec3 n)
{
    vec3 axis = cross(a, b);
    float s = length(axis);
    return s > 1e-7 ? atan(s, dot(a, b)) / s * dot(axis, n) : 0.0;
}

/// Cosine-weighted share of the hemisphere, 0 to 1, that a rectangle covers as seen from p; clipped at the horizon.
float rect_form_factor(GpuLight light, vec3 p, vec3 n)
{
    vec3 centre = light.position - p;
    if (dot(centre, light.direction) >= 0.0) return 0.0; // behind its one side
    vec3 corners[4] = vec3[](centre - light.half_right - light.half_up, centre + light.half_right - light.half_up,
                             centre + light.half_right + light.half_up, centre - light.half_right + light.half_up);
    vec3 clipped[5];
    int count = 0;
    for (int i = 0; i < 4; ++i) {
        vec3 a = corners[i], b = corners[(i + 1) & 3];
        float ha = dot(a, n), hb = dot(b, n);
        if (ha > 0.0 && count < 5) clipped[count++] = a;
        if ((ha > 0.0) != (hb > 0.0) && count < 5) clipped[count++] = mix(a, b, ha / (ha - hb));
    }
    if (count < 3) return 0.0;
    float sum = 0.0;
    for (int i = 0; i < count; ++i) sum += edge_integral(normalize(clipped[i]), normalize(clipped[(i + 1) % count]), n);
    return abs(sum) / (2.0 * brdf_pi);
}

/// The point of the rectangle nearest to the reflected ray stands for all of it. Source: Karis 2013, "Real Shading in
/// Unreal Engine 4", representative point.
vec3 rect_specular(GpuLight light, vec3 p, vec3 n, vec3 v, Brdf b)
{
    vec3 centre = light.position - p;
    if (dot(centre, light.direction) >= 0.0) return vec3(0.0);
    vec3 r = reflect(-v, n);
    float facing = dot(r, light.direction);
    float t = facing < -1e-4 ? dot(centre, light.direction) / facing : 1e4;
    vec3 offset = r * t - centre;
    float w2 = dot(light.half_right, light.half_right), h2 = dot(light.half_up, light.half_up);
    vec3 nearest = centre + light.half_right * clamp(dot(offset, light.half_right) / w2, -1.0, 1.0) +
                   light.half_up * clamp(dot(offset, light.half_up) / h2, -1.0, 1.0);
    float d2 = max(dot(nearest, nearest), 1e-4);
    vec3 l = nearest * inversesqrt(d2);
    float n_l = dot(n, l);
    if (n_l <= 0.0) return vec3(0.0);
    // The lobe widens by the light's size; its energy stays.
    float alpha = sqrt(b.alpha2);
    float widened = clamp(alpha + 0.5 * sqrt(sqrt(w2 * h2) / d2), 0.0, 1.0);
    Brdf wide = b;
    wide.alpha2 = widened * widened;
    wide.g_v = sqrt(b.n_v * b.n_v * (1.0 - wide.alpha2) + wide.alpha2);
    float solid_angle = min(4.0 * sqrt(w2 * h2) * max(dot(-l, light.direction), 0.0) / d2, 2.0 * brdf_pi);
    return brdf_specular(wide, n_l, dot(v, l)) * (n_l * solid_angle);
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
    vec3 diffuse = b.diffuse * (brdf_pi * rect_form_factor(light, p, n));
    return light.color * (diffuse + rect_specular(light, p, n, v, b));
}

/// Whether a light reaches p at all: range, cone, the front of a rectangle.
bool light_reaches(GpuLight light, vec3 p)
{
    if (light.type == light_rect) return dot(light.position - p, light.direction) < 0.0;
    vec3 l;
    return light_falloff(light, p, l) > 0.0;
}

#endif
