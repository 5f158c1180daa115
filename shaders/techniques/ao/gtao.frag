#version 460
// Ambient occlusion from horizons: in planes through the line of sight ("slices"), how high the scene rises on either
// side, and in closed form what that hides of the cosine-weighted hemisphere.
// Source: Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion".
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
#include "techniques/ao/ao.glsl"

layout(constant_id = 0) const uint slices = 1;
layout(constant_id = 1) const uint steps = 9; // on each side
layout(location = 0) out vec2 out_ao;

const float pi = 3.14159265;
const float nearest_step = 1.3; // pixels: nearer ones lie in the pixel itself
const float least_radius = 2.0; // pixels: nothing smaller can be seen
const float widest = 0.6;       // of the picture's height: farther samples would leave the near ones too few
const float longest_way = 1.5;  // radii between two points of one surface, wherever they lie
const float straight = 0.1;     // tangent of the bend up to which three points lie on one surface, however far apart
const float favour = 0.7;       // how much more often slices are drawn along the slope of a plane

/// A point of the scene in a slice. Lengths along the line of sight count 1 + push.thin times.
struct Point {
    vec2 d;        // from the pixel's own point: away from the line of sight, and along it towards the eye
    float length2; // of d
    bool over;     // the pixel's plane
};

/// What was seen on one side of a slice.
struct Side {
    vec2 top;      // direction of the horizon so far
    float nearest; // to the line of sight, of what rises over the plane within the radius
    Point last;
    vec2 way;      // to the last point from the one before
};

float cross(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

/// Distance along the view axis; far away where nothing stands and off the picture.
float distance_at(ivec2 pixel)
{
    uvec2 at = uvec2(pixel), inside = min(at, uvec2(frame.size) - 1u);
    float depth = fetch_depth(ivec2(inside));
    return view_distance(at == inside ? max(depth, 1e-9) : 1e-9);
}

/// The point at distance `z` on a ray that differs from the pixel's by `step`. That and the pixel's own `ray` are given
/// by their parts: step.x away from the line of sight; step.y, ray.x along it; step.z, ray.y along the normal.
Point seen(float z, float own_z, vec3 step, vec2 ray)
{
    vec2 along = z * step.yz + (z - own_z) * ray, d = vec2(z * step.x, along.x);
    float length2 = dot(d, d);
    // A plane seen through pixels' centres is never quite in the slice: what hardly rises over it is part of it.
    return Point(d, length2, along.y * abs(along.y) > 1e-4 * length2);
}

/// Takes in the next point, and what lies within the radius on the way to it: few samples would else step over it.
void walk(inout Side side, Point next, float radius2)
{
    Point last = side.last;
    vec2 way = next.d - last.d;
    float way2 = dot(way, way), slope = dot(last.d, way), inverse = 1.0 / max(way2, 1e-12);
    float root = sqrt(max(slope * slope - way2 * (last.length2 - radius2), 0.0));
    float from = clamp((-slope - root) * inverse, 0.0, 1.0), to = clamp((-slope + root) * inverse, 0.0, 1.0);
    // A long way leads from one surface to another, with nothing between; not if it goes on straight, as on a ceiling
    // that is seen at a slant.
    bool bends = abs(cross(side.way, way)) >= straight * dot(side.way, way);
    bool leap = bends && way2 > longest_way * longest_way * radius2;
    bool rises = (last.over || next.over) && (leap ? next.length2 < radius2 : from < to);
    from = leap ? 1.0 : from;
    to = leap ? 1.0 : to;

    vec2 top = last.d + (cross(last.d, next.d) >= 0.0 ? to : from) * way;
    side.top = rises && cross(side.top, top) > 0.0 ? top : side.top;
    side.nearest = rises ? min(side.nearest, last.d.x + from * way.x) : side.nearest;
    side.last = next;
    side.way = way;
}

/// Visibility between the line of sight and an angle, whose cosine is given, on the side towards which the normal has
/// the component `ns`; `nv`: along the line of sight. Two open sides come to 1, on average over all slices.
float arc(float c, float nv, float ns)
{
    float s2 = max(1.0 - c * c, 0.0);
    return 0.5 * (nv * s2 + ns * (acos(clamp(c, -1.0, 1.0)) - c * sqrt(s2)));
}

/// What is hidden on one side: from the horizon down to where things, endless along the view, leave the radius. Mostly
/// that is under the plane; below a ceiling it is not.
float hidden(Side side, float radius2, float nv, float ns)
{
    float stretch = 1.0 + push.thin;
    vec2 top = side.top / vec2(1.0, stretch);
    float across2 = side.nearest * side.nearest, behind2 = (radius2 - across2) / (stretch * stretch);
    float cos_top = top.y * inversesqrt(dot(top, top)), cos_plane = -ns * inversesqrt(max(nv * nv + ns * ns, 1e-12));
    float cos_bottom = clamp(-sqrt(behind2 / (across2 + behind2)), cos_plane, cos_top);
    return arc(cos_bottom, nv, ns) - arc(cos_top, nv, ns);
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
    z *= 0.99999; // before the surface
    vec3 ray = ray_of(pixel), n = plane_normal(pixel);
    float ray_length = length(ray), stretch = 1.0 + push.thin;
    vec3 v = ray / -ray_length;
    float nv = max(dot(n, v), 0.0);
    vec3 slope = n - nv * v; // of the plane, across the line of sight
    vec2 ray_in_slice = -ray_length * vec2(stretch, nv);
    vec2 pixel_step = vec2(2.0, -2.0) * frame.inv_size * vec2(frame.tan_x, frame.tan_y); // of rays

    uint noise = bayer(texel);
    float turn = float(noise) / 16.0, shift = fract(float(noise) * 0.61803399 + 0.5);
    float sum = 0.0;
    for (uint i = 0u; i < slices; ++i) {
        // Across the line of sight. Turned evenly on the screen; what slices weigh makes up for where they crowd.
        float phi = pi * (float(i) + turn) / float(slices);
        vec3 side = vec3(cos(phi), sin(phi), 0.0);
        side -= dot(side, v) * v;
        side += favour * dot(side, slope) * slope;
        float inverse = inversesqrt(dot(side, side));
        float weight = v.z * (1.0 + favour * dot(slope, slope)) * inverse * inverse;
        side *= inverse;
        float ns = dot(n, side);
        vec2 along = radius * vec2(1.0, -1.0) * (side.xy + ray.xy * side.z); // on the screen, pixels

        // Each slice has a radius of its own: on average what stands far out counts less and less.
        float reach = push.radius * (1.0 - push.falloff * fract(turn + 0.5 * shift + float(i) * 0.75487767));
        float reach2 = reach * reach, jitter = fract(shift + float(i) * 0.61803399);
        Point own = Point(vec2(0.0), 0.0, false);
        Side ahead = Side(vec2(nv, -ns * stretch), reach, own, vec2(0.0)), behind = ahead;
        behind.top.y = ns * stretch;
        [[unroll]] // a sixth faster on lavapipe, where loops blend what they carry with masks
        for (uint k = 0u; k < steps; ++k) {
            float s = (float(k) + jitter) / max(float(steps) - 0.6, 0.9); // the last about the radius
            vec2 offset = round(along * max(s * s, nearest_step / radius)), ray_step = offset * pixel_step;
            vec3 step = vec3(dot(ray_step, side.xy), stretch * dot(ray_step, v.xy), dot(ray_step, n.xy));
            walk(ahead, seen(distance_at(pixel + ivec2(offset)), z, step, ray_in_slice), reach2);
            walk(behind, seen(distance_at(pixel - ivec2(offset)), z, vec3(step.x, -step.yz), ray_in_slice), reach2);
        }
        sum += weight * (hidden(ahead, reach2, nv, ns) + hidden(behind, reach2, nv, -ns));
    }
    out_ao.x = reckoned(1.0 - sum / float(slices));
}
