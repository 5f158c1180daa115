#version 460
// Ambient occlusion by points in the half ball over the surface: how many of them lie behind what the camera sees.
// Source: Mittring 2007, "Finding Next Gen: CryEngine 2"; oriented by the normal: Filion, McNaughton 2008, "Effects &
// Techniques" (StarCraft II).
#extension GL_GOOGLE_include_directive : require
#include "techniques/ao/ao.glsl"

layout(constant_id = 0) const uint samples = 16;
layout(location = 0) out vec2 out_ao;

const float pi = 3.14159265;
const float least_radius = 4.0; // pixels: below, it fades

/// The i-th point, uniform in the volume of the half ball over z. Source: golden-ratio sequences, Roberts 2018.
vec3 point(uint i, float noise)
{
    float u = (float(i) + 0.5) / float(samples);
    float height = fract(0.5 + float(i) * 0.75487767 + noise * 0.569840291);
    float phi = 2.0 * pi * (float(i) * 0.61803399 + noise);
    float across = sqrt(1.0 - height * height);
    return vec3(across * cos(phi), across * sin(phi), height) * pow(u, 1.0 / 3.0);
}

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy), pixel = pixel_of(texel);
    float depth = fetch_depth(pixel);
    out_ao = vec2(1.0, no_surface);
    if (depth <= 0.0) return;

    float z = view_distance(depth);
    out_ao.y = z;
    vec3 p = ray_of(pixel) * z, n = plane_normal(pixel);
    float fade = smoothstep(0.5, 1.0, push.radius * 0.5 * frame.size.y / (frame.tan_y * z) / least_radius);

    vec3 t = normalize(abs(n.y) < 0.9 ? cross(n, vec3(0.0, 1.0, 0.0)) : cross(n, vec3(1.0, 0.0, 0.0)));
    vec3 b = cross(n, t);
    float noise = float(bayer(texel)) / 16.0, bias = 0.02 * push.radius;
    float occluded = 0.0;
    for (uint i = 0u; i < samples; ++i) {
        vec3 x = point(i, noise);
        vec3 s = p + push.radius * (x.x * t + x.y * b + x.z * n);
        if (s.z >= -frame.near) continue;
        vec2 ndc = s.xy / (-s.z * vec2(frame.tan_x, frame.tan_y));
        vec2 at = vec2(0.5, -0.5) * (ndc - frame.corner) * frame.size;
        if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, frame.size))) continue;
        float scene_depth = fetch_depth(ivec2(at));
        if (scene_depth <= 0.0) continue;
        float scene = view_distance(scene_depth);
        vec3 d = ray_of(ivec2(at)) * scene - p; // seen at a slant, the surface itself lies before some points: no occluder
        if (scene < -s.z - bias && dot(d, n) > 0.02 * length(d)) occluded += smoothstep(0.0, 1.0, push.radius / max(abs(z - scene), 1e-6));
    }
    out_ao.x = reckoned(1.0 - fade * occluded / float(samples));
}
