#version 460
// The sky where no geometry was drawn, and the floor below the scene, which fades to the horizon's colour.
#extension GL_GOOGLE_include_directive : require
#include "lib/color.glsl"
#include "lib/lights.glsl"
#include "lib/sky.glsl"
#include "techniques/sky/floor.glsl"

layout(constant_id = 0) const bool rects = true;     // there are rectangle lights
// Whether to read ambient occlusion and visibility. If not, both are 1 everywhere.
layout(constant_id = 1) const bool occluded = true;
layout(constant_id = 2) const bool shadowed = true;
layout(PASS_IMAGE(0)) uniform texture2D floor_depth;
layout(PASS_IMAGE(1)) uniform texture2D ao_image;
layout(PASS_IMAGE(2)) uniform texture2DArray visibility_images; // a layer for each light that casts shadows
layout(location = 0) out vec4 out_radiance;

const float floor_albedo = 0.22; // under the default sun a little darker than the horizon

float visibility_of(uint layer, ivec2 pixel)
{
    if (!shadowed || layer == no_shadow_layer) return 1.0;
    return texelFetch(visibility_images, ivec3(pixel, layer), 0).x;
}

/// Radiance of a grey, diffuse floor. Lights keep their colour; ambient light enters by luminance only, which keeps shadows
/// grey.
vec3 floor_radiance(ivec2 pixel, vec3 p, vec3 v)
{
    const vec3 up = vec3(0.0, 1.0, 0.0);
    Brdf b = make_brdf(vec3(floor_albedo), 0.0, 1.0, 0.0, v.y);
    float ao = occluded ? min(texelFetch(ao_image, pixel, 0).x, 1.0) : 1.0;
    vec3 sum = vec3(floor_albedo * ao * luminance(frame.ambient_sky));
    for (uint i = 0u; i < frame.light_count; ++i) {
        GpuLight light = frame.lights[i];
        bool is_rect = rects && light.type == light_rect;
        vec3 lit = is_rect ? shade_rect(light, p, up, v, b) : shade_delta(light, p, up, v, b);
        sum += lit * visibility_of(light.shadow_layer, pixel);
    }
    return sum;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 ray = view_ray(gl_FragCoord.xy), color = ray.y < 0.0 ? frame.sky_horizon : sky_radiance(normalize(ray));
    float depth = texelFetch(floor_depth, pixel, 0).x;
    if (depth > 0.0) {
        vec3 p = frame.eye + ray * view_distance(depth);
        color = mix(color, floor_radiance(pixel, p, -normalize(ray)), floor_share(p));
    }
    out_radiance = vec4(min(color, vec3(half_float_top)), 1.0);
}
