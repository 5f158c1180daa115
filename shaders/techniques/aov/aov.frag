#version 460
// One value of the G-buffer, unpacked to 32-bit floats in world space and physical units.
#extension GL_GOOGLE_include_directive : require
#include "lib/color.glsl"
#include "lib/gbuffer.glsl"
#include "lib/lights.glsl"
#include "lib/scene.glsl"
#include "shared/aov.h"

layout(constant_id = 0) const uint kind = aov_depth;
layout(push_constant, scalar) uniform Push { AovPush push; };
layout(PASS_IMAGE(5)) uniform texture2D motion;
layout(PASS_IMAGE(6)) uniform texture2D image; // aov_hdr: radiance x exposure; aov_ao, aov_ao_raw: ambient occlusion
layout(location = 0) out vec4 out_value;

vec4 background()
{
    switch (kind) {
    case aov_depth: return vec4(1.0 / 0.0);
    case aov_material:
    case aov_mesh:
    case aov_instance: return vec4(-1.0);
    default: return vec4(0.0);
    }
}

float count_lights(vec3 p)
{
    float count = 0.0;
    for (uint i = 0u; i < frame.light_count; ++i) count += light_reaches(frame.lights[i], p) ? 1.0 : 0.0;
    return count;
}

vec4 value(ivec2 pixel, uint id)
{
    Surface s = fetch_surface(pixel, id);
    float distance = view_distance(fetch_depth(pixel));
    vec3 p = frame.eye + view_ray(gl_FragCoord.xy) * distance;
    switch (kind) {
    case aov_depth: return vec4(distance);
    case aov_position: return vec4(p, 0.0);
    case aov_geometric_normal: return vec4(s.geometric_normal, 0.0);
    case aov_normal: return vec4(s.normal, 0.0);
    case aov_albedo: return vec4(s.base_color, 0.0);
    case aov_roughness: return vec4(s.roughness);
    case aov_metallic: return vec4(s.metallic);
    case aov_specular: return vec4(s.specular);
    case aov_emission: return vec4(unpack_rgb9e5(texelFetch(gbuffer_emission, pixel, 0).x) / frame.exposure, 0.0);
    case aov_material: return vec4(float(record_table[s.record].material));
    case aov_mesh: return vec4(float(record_table[s.record].mesh));
    case aov_instance: return vec4(float(record_table[s.record].instance));
    case aov_motion: return vec4(texelFetch(motion, pixel, 0).xy, 0.0, 0.0);
    case aov_light_count: return vec4(count_lights(p));
    default: return vec4(0.0);
    }
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (kind == aov_constant) {
        out_value = vec4(push.background);
    } else if (kind == aov_hdr) {
        out_value = vec4(texelFetch(image, pixel, 0).rgb / frame.exposure, 0.0);
    } else if (kind == aov_ao || kind == aov_ao_raw) {
        out_value = vec4(min(texelFetch(image, pixel / int(push.scale), 0).x, 1.0));
    } else {
        uint id = fetch_id(pixel);
        out_value = is_background(id) ? background() : value(pixel, id);
    }
}
