// A point that may lie in shadow, in a light's shadow map.
//
// Light space: the light's own axes right, up, front; from the light, m (sun: from the world's origin). Everything about
// the map is in texels of the face's tile, x right and y down, from its upper left corner. Depth is reversed. Both kinds
// of depth (near / z, and linear for the sun) are linear in texels across a plane, which is why one slope says what to
// compare with anywhere around the receiver. Heights are above the receiver's plane, towards the light, in depth.
#include "lib/brdf.glsl"
#include "lib/depth_normal.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/textures.glsl"
#include "shared/light.h"
#include "techniques/shadow/depth_range.glsl"

layout(constant_id = 0) const uint light_kind = light_spot;
layout(constant_id = 1) const uint shadow_filter = shadow_pcss;
layout(constant_id = 2) const uint blocker_count = 16;
layout(constant_id = 3) const uint sample_count = 32;
layout(constant_id = 4) const uint shown = show_visibility;
layout(constant_id = 5) const bool blurred = false; // what is written is going to be
layout(constant_id = 6) const bool beyond_scene = false; // receivers may lie behind the far side of a sun's map

layout(PASS_IMAGE(2)) uniform texture2D shadow_map;
layout(PASS_BUFFER(0), scalar) readonly buffer Faces { ShadowFace faces[]; };
layout(PASS_BUFFER(1), scalar) readonly buffer Samples { vec4 sample_table[]; };
layout(PASS_BUFFER(2), scalar) readonly buffer Ranges { vec2 ranges[]; };
layout(push_constant, scalar) uniform Push { VisibilityPush push; };

const bool perspective = light_kind != light_sun;
const float least_cosine = 0.02; // of a receiver's slope: what is steeper has the slope of this

vec3 to_light_space(vec3 v) { return vec3(dot(v, push.right), dot(v, push.up), dot(v, push.front)); }

/// What a pixel shows, in light space.
struct Surfel {
    vec3 p;         // m
    vec3 n;         // unit normal of the triangle's plane, towards the camera
    float distance; // from the light, m; sun: 1
    float rise;     // cosine between the normal and the direction to the light
    vec2 spacing2;  // of pixels on it, across and down the picture, m, squared; where it is to be blurred
};

/// Between neighbouring pixels' points on a plane with this normal, across and down the picture, m, squared.
vec2 pixel_spacing2(vec3 n, vec3 ray, float distance)
{
    vec2 along = vec2(dot(ray, frame.right), dot(ray, frame.up));
    vec2 scale = 2.0 * distance * vec2(frame.tan_x, frame.tan_y) * frame.inv_size;
    vec2 tilt = vec2(dot(n, frame.right), dot(n, frame.up)) / dot(n, ray);
    return (1.0 + tilt * (tilt * dot(ray, ray) - 2.0 * along)) * scale * scale;
}

Surfel fetch_surfel(ivec2 pixel, float depth)
{
    float z = view_distance(depth);
    vec3 ray = view_ray(gl_FragCoord.xy), p = frame.eye + ray * z;
    vec3 n = fetch_geometric_normal(pixel);
    Surfel s;
    s.p = to_light_space(perspective ? p - push.position : p);
    s.n = to_light_space(n);
    s.spacing2 = blurred ? pixel_spacing2(n, ray, z) : vec2(0.0);
    s.distance = perspective ? length(s.p) : 1.0;
    s.rise = perspective ? -dot(s.n, s.p) / s.distance : -s.n.z;
    return s;
}

/// Whether the light shines there, were nothing in between: range, cone, the front of a rectangle.
bool reached(Surfel s)
{
    if (!perspective) return true;
    vec3 p = s.p + push.from_centre;
    float distance = length(p);
    if (push.range > 0.0 && distance >= push.range) return false;
    if (light_kind == light_spot) return p.z > push.cos_outer * distance;
    return light_kind != light_rect || p.z > 0.0;
}

/// How far a rectangle reaches from its centre across the surface's plane, m.
float extent_across(Surfel s) { return abs(s.n.x) * push.half_width + abs(s.n.y) * push.half_height; }

/// Share of the light, a disc that faces the surface, that lies above the surface's own plane. Of rectangles lighting
/// takes the part above; theirs is 1 or 0.
float share_above_horizon(Surfel s)
{
    if (shadow_filter != shadow_pcss) return s.rise > 0.0 ? 1.0 : 0.0;
    float height = s.rise * s.distance;
    if (light_kind == light_rect) {
        return height + extent_across(s) > 0.0 ? 1.0 : 0.0;
    }
    if (height >= push.size) return 1.0;
    float x = clamp(height / max(push.size * sqrt(max(1.0 - s.rise * s.rise, 0.0)), 1e-6), -1.0, 1.0);
    return 0.5 + (x * sqrt(1.0 - x * x) + asin(x)) / brdf_pi;
}

/// One face of a cube: which of the light's axes it looks along, and whether the other way.
struct Face {
    uint index; // among the tiles
    uint axis;
    float side; // 1 or -1
};

/// A vector of light space in the face's axes: x right, y up, z along it.
vec3 to_face(Face f, vec3 v)
{
    if (light_kind == light_spot || light_kind == light_sun) return v;
    vec3 turned = f.axis == 0u ? vec3(-v.z, v.y, v.x) : f.axis == 1u ? vec3(-v.x, v.z, v.y) : v;
    return vec3(turned.x * f.side, turned.y, turned.z * f.side);
}

Face cube_face(vec3 p)
{
    vec3 a = abs(p);
    Face f;
    bool x = a.x >= a.y && a.x >= a.z, y = a.y >= a.z;
    f.axis = x ? 0u : y ? 1u : 2u;
    f.side = (x ? p.x : y ? p.y : p.z) >= 0.0 ? 1.0 : -1.0; // no index: it would put p into memory
    f.index = 2u * f.axis + (f.side < 0.0 ? 1u : 0u);
    return f;
}

/// The cascade's map coordinates of a point in the sun's light space.
vec2 on_cascade(uint cascade, vec3 p, out float scale)
{
    uint i = push.first_face + cascade;
    scale = faces[i].scale;
    return p.xy / scale + vec2(faces[i].x.w, faces[i].y.w);
}

/// Sun: the finest cascade that has room for the filter around the surfel, and how far to fade into the next one.
Face choose_cascade(Surfel s, out float fade)
{
    fade = 0.0;
    uint i = 0u;
    for (; i + 1u < push.faces; ++i) {
        float scale;
        vec2 at = on_cascade(i, s.p, scale);
        float margin = shadow_filter == shadow_pcss ? min(2.0 * widest_filter, push.size * (s.p.z - push.near) / scale)
                                                    : 2.0 * push.radius / push.side;
        float room = 1.0 - margin - 4.0 / push.side - max(abs(at.x), abs(at.y));
        if (room <= 0.0) continue;
        fade = clamp(1.0 - room / 0.1, 0.0, 1.0);
        break;
    }
    return Face(i, 2u, 1.0);
}

/// The surfel in one face of the map.
struct Receiver {
    Face face;
    vec2 texel;
    float z;      // m along the face's axis; sun: from its near side
    float depth;
    vec2 slope;   // of depth across the receiver's plane, per texel
    float rise;   // the same to the next texel, either way
    float bias;   // added to depth where it is compared with texels up to half a one away
    vec2 tangent; // perspective: of the direction from the light
    float texels; // half a tile, per tangent or (sun) m
    vec2 spacing2; // as the surfel's
};

Receiver receiver_in(Face face, Surfel s)
{
    Receiver r;
    r.face = face;
    r.spacing2 = s.spacing2;
    vec3 p = to_face(face, s.p), n = to_face(face, s.n);
    float scale = push.scale;
    if (!perspective) on_cascade(face.index, s.p, scale);
    r.texels = 0.5 * push.side / scale;
    float texel = (perspective ? max(p.z, 0.0) : 1.0) / r.texels; // m
    p += n * (texel * push.bias_normal * sqrt(max(1.0 - s.rise * s.rise, 0.0)));

    vec2 at, slope; // in the tile, -1 to 1, y up
    float reckoning; // what floats may be off by
    if (perspective) {
        r.z = p.z;
        r.tangent = p.xy / p.z;
        at = r.tangent / scale;
        r.depth = push.near / p.z;
        vec3 ray = vec3(r.tangent, 1.0);
        float c = min(dot(n, ray), -least_cosine * length(ray)); // the plane's constant / z
        slope = n.xy * (r.depth * scale / c);
        reckoning = r.depth * (4e-6 + 1e-6 * length(push.position) / r.z);
    } else {
        at = on_cascade(face.index, p, scale);
        r.z = p.z - push.near;
        r.tangent = vec2(0.0);
        r.depth = 1.0 - r.z * push.height_per_spread;
        slope = n.xy * (scale * push.height_per_spread / min(n.z, -least_cosine));
        reckoning = 8e-6 + 2e-6 * length(p) * push.height_per_spread;
    }
    r.texel = (vec2(0.5, -0.5) * at + 0.5) * push.side;
    vec2 per_texel = slope * vec2(2.0, -2.0) / push.side;
    float rise = abs(per_texel.x) + abs(per_texel.y);
    r.slope = push.receiver_plane != 0u ? per_texel : vec2(0.0);
    r.rise = rise;
    r.bias = reckoning + rise * (push.bias_slope + (shadow_filter == shadow_hard ? 0.0 : 0.5));
    return r;
}

/// One texel, in the image.
vec2 texel_size() { return vec2(1.0 / (push.side * float(push.faces)), 1.0 / push.side); }

/// What the receiver's plane may be off by so many texels away, in depth: the G-buffer rounds normals to 12 bits, and the
/// steeper the plane, the more that matters.
float plane_error(Receiver r, float texels)
{
    float facing = (perspective ? r.depth : push.height_per_spread) / r.texels; // slope of a plane at 45 degrees
    return texels * (0.0003 * facing + 0.003 * (abs(r.slope.x) + abs(r.slope.y)));
}

/// In the image, of a point of the face's tile.
vec2 map_uv(Receiver r, vec2 texel)
{
    return vec2(float(r.face.index) * push.side + texel.x, texel.y) * texel_size();
}

/// Nearest and farthest depth within `reach` texels of the receiver (and, as cells are coarse, a little around).
vec2 depth_range(Receiver r, float reach)
{
    float wide = 2.0 * (reach + 1.0) / float(shadow_cell);
    uint level = uint(clamp(ceil(log2(max(wide, 1.0))), 0.0, log2(float(push.cells))));
    float cell = float(shadow_cell << level);
    int last = int(push.cells >> level) - 1;
    ivec2 low = clamp(ivec2((r.texel - reach - 1.0) / cell), ivec2(0), ivec2(last));
    ivec2 high = clamp(ivec2((r.texel + reach + 1.0) / cell), ivec2(0), ivec2(last));
    uint first = cell_index(push.cells, push.faces, level, r.face.index, uvec2(0u)), side = uint(last + 1);
    vec2 a = ranges[first + uint(low.y) * side + uint(low.x)], b = ranges[first + uint(low.y) * side + uint(high.x)];
    vec2 c = ranges[first + uint(high.y) * side + uint(low.x)], d = ranges[first + uint(high.y) * side + uint(high.x)];
    return vec2(max(max(a.x, b.x), max(c.x, d.x)), min(min(a.y, b.y), min(c.y, d.y)));
}

/// Nearest depth in the whole face.
float nearest_in_face(Receiver r)
{
    return ranges[cell_index(push.cells, push.faces, uint(findMSB(push.cells)), r.face.index, uvec2(0u))].x;
}

/// m along the face's axis.
float linear_z(float depth) { return perspective ? push.near / depth : (1.0 - depth) / push.height_per_spread; }

/// The light's shape, laid on the map. The spread of something is by how much the light's extent shows on the map past it,
/// as a ray from the receiver to a point o of the light passes it: for lights with a place at tangent + spread (o.xy - o.z
/// tangent), spread = 1/z - 1/receiver's z; for the sun receiver's z - z. So spread grows as height does.
struct LightOnMap {
    mat2 spans;   // texels per spread of the axes of the unit disc (rect: of the square -1 to 1)
    float radius; // of the circle around it, texels per spread
};

/// A vector of the light's plane, light space, in texels per spread.
vec2 on_map(Receiver r, vec3 o)
{
    vec3 f = to_face(r.face, o);
    return (f.xy - f.z * r.tangent) * vec2(r.texels, -r.texels);
}

LightOnMap light_on_map(Receiver r)
{
    LightOnMap l;
    if (light_kind == light_rect) {
        l.spans = mat2(on_map(r, vec3(push.half_width, 0.0, 0.0)), on_map(r, vec3(0.0, push.half_height, 0.0)));
        l.radius = length(l.spans[0]) + length(l.spans[1]);
        return l;
    }
    float size = push.size * r.texels;
    l.spans = mat2(size, 0.0, 0.0, size);
    l.radius = size;
    if (perspective) { // a disc that faces the receiver, seen along the ray on the face's plane: an ellipse
        vec2 t = r.tangent * vec2(1.0, -1.0);
        float t2 = dot(t, t), stretch = sqrt(1.0 + t2);
        l.spans += outerProduct(t, t) * (size * (stretch - 1.0) / max(t2, 1e-8));
        l.radius *= stretch;
    }
    return l;
}

/// On the receiver, m, for the spread that the filter was given.
float penumbra_width(Receiver r, float k)
{
    float size = light_kind == light_rect ? max(push.half_width, push.half_height) : push.size;
    return 2.0 * size * k * (perspective ? r.z : 1.0);
}

/// What tells pixels' samples apart: discs are turned, squares shifted across their borders. In any 4 x 4 pixels, which a
/// blur will average, each sixteenth of what there is is taken once.
struct Pattern {
    mat2 turn;
    vec2 shift;
};

Pattern pixel_pattern()
{
    float noise = interleaved_gradient_noise(gl_FragCoord.xy - 0.5);
    if (blurred) noise = (float(bayer(ivec2(gl_FragCoord.xy))) + noise) / 16.0;
    vec2 t = light_kind == light_rect ? vec2(1.0, 0.0) : unit_vector(noise);
    return Pattern(mat2(t, -t.y, t.x), fract(vec2(noise, noise * 2.61803399)));
}

/// Where the rays to the light's points pass something of one spread, as steps in the image from the receiver, and by how
/// much the receiver's plane rises there. Linear in the spread.
struct Taps {
    mat2 steps; // uv per axis of the light's shape
    vec2 rise;  // depth per axis
};

Taps taps_at(Receiver r, mat2 spans, float k)
{
    mat2 texels = spans * k;
    return Taps(mat2(texels[0] * texel_size(), texels[1] * texel_size()), r.slope * texels);
}

/// A point of the light: of the unit disc, or of the square -1 to 1.
struct LightSample {
    vec2 at;
    float rim, inverse_rim; // how far out it is, 0 to 1 at the light's edge
};

LightSample light_sample(uint i, Pattern pattern)
{
    vec4 s = sample_table[i];
    if (light_kind != light_rect) return LightSample(s.xy, s.z, s.w);
    vec2 at = fract(s.xy + pattern.shift) * 2.0 - 1.0;
    float rim = max(abs(at.x), abs(at.y));
    return LightSample(at, rim, 1.0 / max(rim, 1e-3));
}

/// A set in the table.
struct SampleSet {
    uint first, count;
};

SampleSet sample_set(uint set)
{
    uint first = 0u;
    for (uint before = 0u; before < set; ++before) first += samples_in_set(before, blocker_count, sample_count);
    return SampleSet(first, samples_in_set(set, blocker_count, sample_count));
}

/// Points of a rectangle differ in their distance along the face's axis, and so in where rays to them pass: a factor.
float parallax(Receiver r, LightSample s)
{
    if (light_kind != light_rect) return 1.0;
    float z = to_face(r.face, vec3(push.half_width * s.at.x, push.half_height * s.at.y, 0.0)).z;
    return r.z / max(r.z - z, 0.1 * r.z);
}

/// The receiver's place, from the middle of its tile, which samples may not leave; in the image.
struct Place {
    vec2 uv, middle, half_tile;
};

Place place_of(Receiver r)
{
    vec2 middle = map_uv(r, vec2(0.5 * push.side));
    return Place(map_uv(r, r.texel) - middle, middle, (0.5 * push.side - 0.5) * texel_size());
}

/// Share of four texels in which a depth is seen from the light. What lies beside the tile casts nothing.
float compare(Place place, vec2 to, float depth)
{
    vec2 uv = place.uv + to;
    vec3 at = vec3(uv + place.middle, max(depth, 0.0)); // beyond the plane's horizon it is nothing that is hidden
    float seen = textureLod(sampler2DShadow(shadow_map, comparison_samplers[sampler_shadow]), at, 0.0);
    return any(greaterThan(abs(uv), place.half_tile)) ? 1.0 : seen;
}

/// Height above a depth of what is stored.
float height_at(Place place, vec2 to, float depth)
{
    vec2 uv = place.uv + to;
    float d = textureLod(sampler2D(shadow_map, samplers[sampler_nearest_clamp]), uv + place.middle, 0.0).x;
    if (beyond_scene && !perspective) return any(greaterThan(abs(uv), place.half_tile)) || d <= 0.0 ? -1.0 : d - depth;
    return any(greaterThan(abs(uv), place.half_tile)) ? -1.0 : d - max(depth, 0.0);
}
