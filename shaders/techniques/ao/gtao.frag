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

/// What the square of a distance along the view adds to that of a length.
float thinness() { return push.thin * (2.0 + push.thin); }

/// What a horizon needs to know of a point seen from `p`.
struct Sample {
    vec3 d;         // from p to it
    float along_v;  // of d: along the line of sight
    float along_n;  // and over the plane
    float length2;
    float measure2; // the same where distances along the view count more
};

Sample sample_at(ivec2 pixel, vec3 p, vec3 n, vec3 v)
{
    bool inside = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, ivec2(frame.size)));
    float depth = inside ? max(fetch_depth(pixel), 1e-9) : 1e-9; // nothing there: far away
    vec3 d = ray_of(pixel) * view_distance(depth) - p;
    float length2 = dot(d, d);
    return Sample(d, dot(d, v), dot(d, n), length2, length2 + thinness() * d.z * d.z);
}

/// Cosine of the horizon that a point makes; `tangent`: that of the surface's own plane.
float horizon(float along_v, float along_n, float length2, float tangent)
{
    float inverse = inversesqrt(max(length2, 1e-12));
    // A plane seen through pixels' centres is never quite in the slice: what does not rise over it is no horizon.
    return along_n * inverse < 0.01 ? tangent : max(tangent, along_v * inverse);
}

/// The horizon of what lies within `radius` on the way from one sample to the next: few samples would else step over it.
/// Sines and lengths of the points between follow from those of the ends.
float horizon_between(Sample a, Sample b, float radius2, float tangent)
{
    float ab = dot(a.d, b.d), measure_ab = ab + thinness() * a.d.z * b.d.z;
    float dd = a.measure2 + b.measure2 - 2.0 * measure_ab, ad = measure_ab - a.measure2;
    if (dd > longest_way * longest_way * radius2) { // from one surface to another
        return b.measure2 <= radius2 ? horizon(b.along_v, b.along_n, b.length2, tangent) : tangent;
    }
    float root2 = ad * ad - dd * (a.measure2 - radius2);
    if (root2 <= 0.0) return tangent;
    float root = sqrt(root2), inverse = 1.0 / dd;
    float from = max((-ad - root) * inverse, 0.0), to = min((-ad + root) * inverse, 1.0);
    if (from >= to) return tangent;
    vec2 t = vec2(from, to), along_v = mix(vec2(a.along_v), vec2(b.along_v), t), along_n = mix(vec2(a.along_n), vec2(b.along_n), t);
    vec2 length2 = a.length2 + t * (2.0 * (ab - a.length2) + t * (a.length2 + b.length2 - 2.0 * ab));
    return max(horizon(along_v.x, along_n.x, length2.x, tangent), horizon(along_v.y, along_n.y, length2.y, tangent));
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
        Sample last_ahead = Sample(vec3(0.0), 0.0, 0.0, 0.0, 0.0), last_behind = last_ahead;
        for (uint k = 0u; k < steps; ++k) {
            float s = (float(k) + fract(shift + float(i) * 0.61803399)) / (float(steps) - 0.5); // the last about the radius
            vec2 offset = vec2(along.x, -along.y) * max(s * s * radius, nearest_step);
            vec2 centre = vec2(pixel) + 0.5;
            Sample now_ahead = sample_at(ivec2(floor(centre + offset)), p, n, v);
            Sample now_behind = sample_at(ivec2(floor(centre - offset)), p, n, v);
            ahead = max(ahead, horizon_between(last_ahead, now_ahead, reach * reach, tangent_ahead));
            behind = max(behind, horizon_between(last_behind, now_behind, reach * reach, tangent_behind));
            last_ahead = now_ahead;
            last_behind = now_behind;
        }
        float h_ahead = acos(clamp(ahead, -1.0, 1.0)), h_behind = -acos(clamp(behind, -1.0, 1.0));
        sum += weight * (inner_arc(h_ahead, ahead, sqrt(max(0.0, 1.0 - ahead * ahead)), cos_n, sin_n) +
                         inner_arc(h_behind, behind, -sqrt(max(0.0, 1.0 - behind * behind)), cos_n, sin_n));
    }
    out_ao.x = reckoned(sum / float(slices)); // over 1 in some pixels, so that the mean is right
}
