// The material model: Lambert plus GGX with height-correlated Smith masking and Schlick's Fresnel. C++ twin:
// tests/gpu/brdf_twin.hpp. Source: Walter et al. 2007; Heitz 2014; Schlick 1994.
#ifndef BRDF_GLSL
#define BRDF_GLSL

const float brdf_pi = 3.14159265358979;
const float min_roughness = 0.045; // perceptual; below it the lobe is narrower than half floats and pixels can hold

/// What of a surface is the same for all lights.
struct Brdf {
    vec3 diffuse; // albedo / pi of the diffuse lobe
    vec3 f0;
    float f90;
    float alpha2; // squared GGX alpha, alpha = roughness^2
    float n_v;    // cosine to the eye, > 0
    float g_v;    // sqrt(n_v^2 (1 - alpha2) + alpha2)
};

Brdf make_brdf(vec3 base_color, float metallic, float roughness, float specular, float n_v)
{
    Brdf b;
    b.diffuse = base_color * ((1.0 - metallic) / brdf_pi);
    b.f0 = mix(vec3(specular), base_color, metallic);
    b.f90 = clamp(16.5 * (b.f0.r + b.f0.g + b.f0.b), 0.0, 1.0);
    float alpha = max(roughness, min_roughness);
    alpha *= alpha;
    b.alpha2 = alpha * alpha;
    b.n_v = max(n_v, 1e-4);
    b.g_v = sqrt(b.n_v * b.n_v * (1.0 - b.alpha2) + b.alpha2);
    return b;
}

/// D V, and D V (1 - v.h)^5: the specular lobe but for f0 and f90. cos2_h and sin2_h are squares of n.h and of its
/// sine: where both are known well, so is the peak of a smooth surface.
vec2 brdf_specular_parts(Brdf b, float n_l, float cos2_h, float sin2_h, float v_h)
{
    float d = cos2_h * b.alpha2 + sin2_h;
    float g_l = sqrt(n_l * n_l * (1.0 - b.alpha2) + b.alpha2);
    float dv = b.alpha2 / (2.0 * brdf_pi * d * d * (n_l * b.g_v + b.n_v * g_l));
    float f = 1.0 - v_h;
    float f2 = f * f;
    return vec2(dv, dv * (f2 * f2 * f));
}

/// What the parts, or sums of them, are together.
vec3 brdf_specular_sum(Brdf b, vec2 parts) { return b.f0 * parts.x + (vec3(b.f90) - b.f0) * parts.y; }

/// Specular lobe f_s; n_l > 0 and v_l are cosines of the light to normal and eye.
vec3 brdf_specular(Brdf b, float n_l, float v_l)
{
    float inv_h = inversesqrt(max(2.0 + 2.0 * v_l, 1e-8)); // 1 / |v + l|
    float n_h = clamp((n_l + b.n_v) * inv_h, 0.0, 1.0), cos2_h = n_h * n_h;
    return brdf_specular_sum(b, brdf_specular_parts(b, n_l, cos2_h, 1.0 - cos2_h, (1.0 + v_l) * inv_h));
}

/// Both lobes.
vec3 brdf_evaluate(Brdf b, float n_l, float v_l) { return b.diffuse + brdf_specular(b, n_l, v_l); }

#endif
