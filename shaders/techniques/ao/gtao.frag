#version 460
// Ambient occlusion from horizons: in each of a few planes through the line of sight, how high the scene rises on either
// side, and in closed form what that leaves of the cosine-weighted hemisphere.
// Source: Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion".
#extension GL_GOOGLE_include_directive : require
#include "techniques/ao/ao.glsl"

layout(constant_id = 0) const uint slices = 3;
layout(constant_id = 1) const uint steps = 3; // on each side
layout(location = 0) out vec2 out_ao;

const float pi = 3.14159265;
const float nearest_step = 1.3;  // pixels: nearer ones lie in the pixel itself
const float least_radius = 2.0;  // pixels: nothing smaller can be seen
const float widest = 0.6;        // of the picture's height: farther samples would leave the near ones too few
const float longest_way = 2.0;   // radii between samples that still lie on one surface
const vec3 nothing = vec3(0.0, 0.0, -1e6);

/// From `p` to what a pixel shows; far away where it shows nothing.
vec3 towards(ivec2 pixel, vec3 p)
{
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, ivec2(frame.size)))) return nothing;
    float depth = fetch_depth(pixel);
    return depth > 0.0 ? ray_of(pixel) * view_distance(depth) - p : nothing;
}

/// Cosine of the horizon that a point makes; `tangent`: that of the surface's own plane.
float horizon_of(vec3 d, vec3 n, vec3 v, float tangent)
{
    float inverse = inversesqrt(max(dot(d, d), 1e-12));
    // A plane seen through pixels' centres is never quite in the slice: what does not rise over it is no horizon.
    return dot(d, n) * inverse < 0.01 ? tangent : max(tangent, dot(d, v) * inverse);
}

/// The same of what lies within `radius` on the way from one sample to the next: few samples would else step over it.
float horizon_between(vec3 a, vec3 b, float radius, vec3 n, vec3 v, float tangent)
{
    vec3 d = b - a, measure = vec3(1.0, 1.0, 1.0 + push.thin); // along the view distances may count more
    vec3 ma = measure * a, mb = measure * b, md = measure * d;
    float dd = dot(md, md);
    if (dd > longest_way * longest_way * radius * radius) { // from one surface to another
        return dot(mb, mb) <= radius * radius ? horizon_of(b, n, v, tangent) : tangent;
    }
    float ad = dot(ma, md), root2 = ad * ad - dd * (dot(ma, ma) - radius * radius);
    if (root2 <= 0.0) return tangent;
    float root = sqrt(root2), from = max((-ad - root) / dd, 0.0), to = min((-ad + root) / dd, 1.0);
    if (from >= to) return tangent;
    return max(horizon_of(a + from * d, n, v, tangent), horizon_of(a + to * d, n, v, tangent));
}

/// Visibility of one side of a slice, `h` its horizon, signed from the line of sight, whose cosine and sine are given.
float inner_arc(float h, float cos_h, float sin_h, float cos_n, float sin_n)
{
    float cos_2h = 2.0 * cos_h * cos_h - 1.0, sin_2h = 2.0 * sin_h * cos_h;
    return 0.25 * (cos_n + 2.0 * h * sin_n - (cos_2h * cos_n + sin_2h * sin_n));
}

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy), pixel = pixel_of(texel);
    float depth = fetch_depth(pixel);
    out_ao = vec2(1.0, no_surface);
    if (depth <= 0.0) return;

    float z = view_distance(depth);
    out_ao.y = z;
    float radius = push.radius * 0.5 * frame.size.y / (frame.tan_y * z); // pixels
    if (radius < least_radius) return;
    radius = min(radius, widest * frame.size.y);
    vec3 ray = ray_of(pixel), p = ray * (z * 0.99999), n = plane_normal(pixel), v = -normalize(ray);

    // Slices stand evenly around the line of sight, not around the view's axis: else a plane would not come out open.
    vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), v)), up = cross(v, right);

    uint noise = bayer(texel);
    float turn = float(noise) / 16.0, shift = fract(float(noise) * 0.61803399 + 0.5);
    float sum = 0.0;
    for (uint i = 0u; i < slices; ++i) {
        float phi = pi * (float(i) + turn) / float(slices);
        vec3 side = cos(phi) * right + sin(phi) * up; // of the slice, across the line of sight
        vec2 along = side.xy + ray.xy * side.z;       // on the screen
        vec3 axis = cross(side, v);                   // of the slice's plane
        vec3 in_slice = n - axis * dot(n, axis);
        float weight = length(in_slice);
        float cos_n = clamp(dot(in_slice, v) / max(weight, 1e-6), 0.0, 1.0);
        float sin_n = dot(in_slice, side) / max(weight, 1e-6);

        float ahead = -sin_n, behind = sin_n; // cosines of the horizons, at first of the plane's own
        float tangent_ahead = ahead, tangent_behind = behind;
        // Each slice has a radius of its own: on average what stands far out counts less and less.
        float reach = push.radius * (1.0 - push.falloff * fract(turn + 0.5 * shift + float(i) * 0.75487767));
        vec3 last_ahead = vec3(0.0), last_behind = vec3(0.0);
        for (uint k = 0u; k < steps; ++k) {
            float s = (float(k) + fract(shift + float(i) * 0.61803399)) / (float(steps) - 0.5); // the last about the radius
            vec2 offset = vec2(along.x, -along.y) * max(s * s * radius, nearest_step);
            vec2 centre = vec2(pixel) + 0.5;
            vec3 now_ahead = towards(ivec2(floor(centre + offset)), p), now_behind = towards(ivec2(floor(centre - offset)), p);
            ahead = max(ahead, horizon_between(last_ahead, now_ahead, reach, n, v, tangent_ahead));
            behind = max(behind, horizon_between(last_behind, now_behind, reach, n, v, tangent_behind));
            last_ahead = now_ahead;
            last_behind = now_behind;
        }
        float h_ahead = acos(clamp(ahead, -1.0, 1.0)), h_behind = -acos(clamp(behind, -1.0, 1.0));
        sum += weight * (inner_arc(h_ahead, ahead, sqrt(max(0.0, 1.0 - ahead * ahead)), cos_n, sin_n) +
                         inner_arc(h_behind, behind, -sqrt(max(0.0, 1.0 - behind * behind)), cos_n, sin_n));
    }
    out_ao.x = pow(max(sum / float(slices), 0.0), push.power); // over 1 in some pixels, so that the mean is right
}
