// The sky: a gradient from horizon to zenith, the ground below, and the disc of each sun. Radiance x exposure.
#ifndef SKY_GLSL
#define SKY_GLSL
#include "lib/frame.glsl"
#include "lib/brdf.glsl"

const float half_float_top = 60000.0; // a sun's disc is brighter than half floats can hold

vec3 sky_gradient(vec3 direction)
{
    float up = direction.y;
    vec3 above = mix(frame.sky_horizon, frame.sky_zenith, sqrt(max(up, 0.0)));
    return mix(above, frame.sky_ground, smoothstep(0.0, 0.04, -up));
}

vec3 sun_discs(vec3 direction)
{
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < frame.light_count; ++i) {
        if (frame.lights[i].type != light_sun) continue;
        float sin2 = frame.lights[i].sin2_radius;
        float cosine = dot(direction, -frame.lights[i].direction);
        if (cosine > 0.0 && 1.0 - cosine * cosine < sin2) sum += frame.lights[i].color / (brdf_pi * sin2);
    }
    return sum;
}

vec3 sky_radiance(vec3 direction)
{
    vec3 discs = direction.y > 0.0 ? sun_discs(direction) : vec3(0.0);
    return min(sky_gradient(direction) + discs, vec3(half_float_top));
}

#endif
