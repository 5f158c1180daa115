#version 460
// How much of a light is seen from each pixel's surface, 0 to 1, from the light's shadow map.
// Sources: Williams 1978, "Casting Curved Shadows on Curved Surfaces"; Reeves et al. 1987, percentage-closer filtering;
// Fernando 2005, "Percentage-Closer Soft Shadows"; Isidoro 2006, "Shadow Mapping: GPU-based Tips and Techniques" (the
// receiver's plane); Holbert 2011, "Saying Goodbye to Shadow Mapping Artifacts" (offset along the normal).
#extension GL_GOOGLE_include_directive : require

const float widest_filter = 1.0 / 8.0; // radius, share of the tile
const float least_search = 2.0;        // texels: the close search reaches as many times further as the wide one beyond it
const float even_height = 0.75;        // share of the mean height from which the harmonic mean tells of blockers of one kind
const float least_height = 0.15;       // share of a kind's blockers' height from which something hides the light's rim
const float least_width = 12.0;        // pixels: of a penumbra that is blurred
const float tiny = 2.0;                // texels: radius of a filter that few comparisons cover

#include "techniques/shadow/receiver.glsl"

layout(location = 0) out float out_value;

struct Shadow {
    float visibility;
    float blocker;  // mean distance of what was found to block, m along the face's axis; infinite: nothing
    float penumbra; // width on the receiver, m
    float blur;     // blur_…
};

const Shadow lit = Shadow(1.0, 1.0 / 0.0, 0.0, blur_full); // as far as its neighbours may be blurred

/// Four texels around the point, each held against the receiver's plane where the texel is, blended by nearness.
Shadow hard_shadow(Receiver r)
{
    vec2 q = clamp(r.texel, vec2(0.5), vec2(push.side - 0.5)) - 0.5, from = floor(min(q, push.side - 2.0)), part = q - from;
    vec4 d = textureGather(sampler2D(shadow_map, samplers[sampler_nearest_clamp]), map_uv(r, from + 1.0));
    float corner = r.depth + r.bias + dot(r.slope, from + 0.5 - r.texel);
    vec4 plane = corner + vec4(r.slope.y, r.slope.x + r.slope.y, r.slope.x, 0.0);
    if (beyond_scene) plane = max(plane, 0.0);
    vec4 seen = vec4(greaterThanEqual(plane, d));
    vec2 row = mix(seen.wx, seen.zy, part.x);
    return Shadow(mix(row.x, row.y, part.y), 1.0 / 0.0, 0.0, blur_none);
}

/// A disc of one size everywhere.
Shadow pcf_shadow(Receiver r, Pattern pattern)
{
    Place place = place_of(r);
    Taps taps = taps_at(r, pattern.turn, push.radius);
    float plane = r.depth + r.bias + 0.5 * r.rise + plane_error(r, push.radius); // a comparison takes texels up to one away
    float sum = 0.0;
    SampleSet set = sample_set(set_filter);
    for (uint i = 0u; i < set.count; ++i) {
        vec2 at = light_sample(set.first + i, pattern).at;
        sum += compare(place, taps.steps * at, plane + dot(taps.rise, at));
    }
    return Shadow(sum / float(set.count), 1.0 / 0.0, 0.0, blur_none);
}

/// What a search for blockers found.
struct Blockers {
    float height;     // mean, above the receiver itself: what rays to the light pass
    float low_height; // harmonic mean above its plane, which the lowest decide
    float count;
};

/// `rise`: of the receiver's plane, from the receiver to there.
void add_blocker(inout Blockers sums, inout float weight, float height, float rise, float least, float hides)
{
    bool blocks = height > 0.0;
    float w = blocks ? clamp(hides, 0.001, 1.0) : 0.0;
    sums.height += w * (height + rise);
    weight += w;
    sums.low_height += blocks ? 1.0 / (height + least) : 0.0;
    sums.count += blocks ? 1.0 : 0.0;
}

/// Searches the map over a spread of `k`, every other time only close around the receiver.
Blockers find_blockers(Receiver r, Place place, LightOnMap light, float k, SampleSet set, Pattern pattern)
{
    float wide = light.radius * k, close = min(sqrt(least_search * wide) / wide, 1.0);
    Taps taps = taps_at(r, light.spans * pattern.turn, k);
    float top = k * push.height_per_spread, least = 0.005 * top, per_top = 1.0 / top, per_close = per_top / close, weight = 0.0;
    float plane = r.depth + r.bias + plane_error(r, wide);
    Blockers sums = Blockers(0.0, 0.0, 0.0);
    add_blocker(sums, weight, height_at(place, vec2(0.0), plane), 0.0, least, 1.0);
    for (uint i = 0u; i < set.count; ++i) {
        LightSample s = light_sample(set.first + i, pattern);
        bool near = (i & 1u) == 1u;
        vec2 at = near ? s.at * close : s.at;
        float rise = dot(taps.rise, at), height = height_at(place, taps.steps * at, plane + rise);
        // What is far out and low cannot hide the light.
        add_blocker(sums, weight, height, rise, least, height * s.inverse_rim * (near ? per_close : per_top));
    }
    return Blockers(max(sums.height / weight, 0.0), max(sums.count / sums.low_height - least, 0.0), sums.count);
}

/// How far visibility may be averaged in a penumbra of this width, m.
float blur_of(Receiver r, float penumbra)
{
    if (!blurred) return blur_none;
    float width2 = penumbra * penumbra;
    vec2 least = least_width * least_width * r.spacing2;
    if (width2 > max(least.x, least.y)) return blur_full;
    return width2 > least.x ? blur_row : width2 > least.y ? blur_column : blur_none;
}

/// For a search over so many texels. `blur`: what the widest penumbra that it can find would allow.
SampleSet search_set(float radius, float blur)
{
    if (!blurred || blur == blur_full || radius < 2.0 * tiny) return sample_set(set_search);
    return sample_set(set_search_narrow);
}

SampleSet filter_set(float radius, float blur)
{
    if (radius < tiny) return sample_set(set_filter_tiny);
    if (!blurred) return sample_set(set_filter);
    return blur == blur_full ? sample_set(set_filter_wide) : sample_set(set_filter_narrow);
}

/// Blockers within what the light spans are sought, the penumbra follows from their mean height, and a filter of its size
/// is laid over the receiver. A mean of something high and something low fits neither: where both were found, each point
/// of the light is looked for twice, among what is high above the receiver, where the ray to it passes the mean blocker,
/// and among what is low, where it passes the low ones.
Shadow pcss_shadow(Receiver r, Pattern pattern)
{
    LightOnMap light = light_on_map(r);
    Place place = place_of(r);
    // Nothing but what lies nearer than the receiver can block, and only within what the light spans at the nearest of it.
    float widest = push.side * widest_filter / light.radius, spread_per_height = 1.0 / push.height_per_spread;
    float k = min((nearest_in_face(r) - r.depth) * spread_per_height, widest);
    if (k <= 0.0) return lit;
    float reach = light.radius * k;
    vec2 range = depth_range(r, reach);
    float tilt = length(r.slope) * reach + r.bias + plane_error(r, reach);
    if (range.x <= r.depth - tilt || (beyond_scene && range.x <= 0.0)) return lit;
    if (range.y > r.depth + tilt && (!beyond_scene || range.y > 0.0)) {
        float least = min((range.y - r.depth) * spread_per_height, widest);
        return Shadow(0.0, linear_z(range.x), 0.0, blur_of(r, penumbra_width(r, least)));
    }
    k = min((range.x - r.depth) * spread_per_height, k);
    if (k <= 0.0) return lit;

    float widest_blur = blur_of(r, penumbra_width(r, k));
    Blockers found = find_blockers(r, place, light, k, search_set(light.radius * k, widest_blur), pattern);
    if (found.count == 0.0) { // at a wide penumbra's bright rim the search often misses; neighbours share the comparisons
        if (widest_blur != blur_full) return lit;
        found = Blockers(range.x - r.depth, range.x - r.depth, 0.0);
    }
    float high_k = clamp(found.height * spread_per_height, 1.0 / light.radius, widest);
    float penumbra = penumbra_width(r, high_k), blur = blur_of(r, penumbra);
    SampleSet set = found.count > 0.0 ? filter_set(light.radius * high_k, blur) : sample_set(set_filter_tiny);
    Taps taps = taps_at(r, light.spans * pattern.turn, high_k);
    float plane = r.depth + r.bias + plane_error(r, light.radius * high_k), seen = 0.0;
    if (found.low_height > even_height * found.height) {
        float least = least_height * found.height;
        for (uint i = 0u; i < set.count; ++i) {
            LightSample s = light_sample(set.first + i, pattern);
            vec2 at = s.at * parallax(r, s);
            seen += compare(place, taps.steps * at, plane + 0.5 * r.rise + dot(taps.rise, at) + least * s.rim);
        }
    } else {
        float border = sqrt(found.low_height * found.height), least = least_height * found.low_height;
        float low = clamp(found.low_height * spread_per_height, 0.5 / light.radius, high_k) / high_k;
        for (uint i = 0u; i < set.count; ++i) {
            LightSample s = light_sample(set.first + i, pattern);
            vec2 at = s.at * parallax(r, s), to = taps.steps * at;
            float rise = dot(taps.rise, at);
            float height = height_at(place, to * low, plane + rise * low);
            bool low_blocks = height > least * s.rim && height <= border;
            seen += low_blocks ? 0.0 : compare(place, to, plane + rise + border);
        }
    }
    return Shadow(seen / float(set.count), linear_z(r.depth + found.height), penumbra, blur);
}

Shadow filtered(Receiver r, Pattern pattern)
{
    if (shadow_filter == shadow_hard) return hard_shadow(r);
    if (shadow_filter == shadow_pcf) return pcf_shadow(r, pattern);
    return pcss_shadow(r, pattern);
}

float background()
{
    if (shown == show_visibility) return 1.0;
    if (shown == show_blocker) return 1.0 / 0.0;
    return shown == show_cascade ? -1.0 : 0.0;
}

float value_at(ivec2 pixel)
{
    float depth = fetch_depth(pixel);
    if (depth <= 0.0) return background();
    Surfel s = fetch_surfel(pixel, depth);
    if (!reached(s)) return background();
    float share = share_above_horizon(s);
    if (share <= 0.0 && shown == show_visibility) return 0.0;

    float fade = 0.0;
    Face face = Face(0u, 2u, 1.0);
    if (light_kind == light_sun) face = choose_cascade(s, fade);
    if (light_kind == light_point || light_kind == light_rect) face = cube_face(s.p);
    if (shown == show_cascade) return light_kind == light_sun ? float(face.index) : background();

    Pattern pattern = pixel_pattern();
    Shadow shadow = filtered(receiver_in(face, s), pattern);
    if (light_kind == light_sun && fade > 0.0) {
        face.index += 1u;
        Shadow next = filtered(receiver_in(face, s), pattern);
        shadow.visibility = mix(shadow.visibility, next.visibility, fade);
        shadow.blur = min(shadow.blur, next.blur);
    }
    // Where the surface's plane cuts a rectangle, the map, drawn from its centre, knows the less of what hides the part above
    // the nearer to the centre it does.
    if (light_kind == light_rect && shadow_filter == shadow_pcss) {
        float above = s.rise * s.distance / max(extent_across(s), 1e-6);
        shadow.visibility = mix(1.0, shadow.visibility, clamp(above, 0.0, 1.0));
    }
    if (shown == show_visibility) return shadow.visibility * share + (blurred ? 2.0 * shadow.blur : 0.0);
    return shown == show_blocker ? shadow.blocker : shadow.penumbra;
}

void main()
{
    out_value = value_at(ivec2(gl_FragCoord.xy)) * push.weight;
}
