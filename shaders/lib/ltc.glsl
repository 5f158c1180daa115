// Light of a rectangle, clipped at the horizon: diffuse in closed form, specular by linearly transformed cosines, which
// the BRDF itself mends at a few points. Source: Baum et al. 1989 (irradiance of a polygon); Heitz, Dupuy, Hill,
// Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines".
#ifndef LTC_GLSL
#define LTC_GLSL
#include "lib/brdf.glsl"
#include "shared/ltc.h"

layout(set = 1, binding = 8, scalar) readonly buffer LtcTable { LtcEntry ltc_table[]; };

/// A rectangle as the surface sees it, m: z along its normal, the eye in y = 0 at x <= 0. Its corners are
/// centre +- right +- up.
struct LocalRect {
    vec3 centre, right, up;
};

/// Where the rectangle is above the horizon: its four edges, cut, and what closes them along the horizon.
struct ClippedRect {
    vec3 from[5], edge[5];
};

/// A specular lobe as a stretched cosine; names as in LtcEntry.
struct LtcLobe {
    float inv_along, inv_across, skew;
    vec2 albedo; // of the lobe with F = 1, and with F = (1 - v.h)^5
};

/// The direction of the cosine that the stretching takes to l; neither has unit length. z stays, and so the horizon.
vec3 cosine_of(LtcLobe m, vec3 l) { return vec3((l.x - m.skew * l.z) * m.inv_along, l.y * m.inv_across, l.z); }

ClippedRect clip_at_horizon(LocalRect r)
{
    vec3 corners[4] = vec3[](r.centre - r.right - r.up, r.centre + r.right - r.up, r.centre + r.right + r.up,
                             r.centre - r.right + r.up);
    ClippedRect c;
    vec3 leaves = vec3(0.0), returns = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        vec3 edge = corners[(i + 1) & 3] - corners[i];
        float a = corners[i].z, b = corners[(i + 1) & 3].z;
        bool from_above = a > 0.0, to_above = b > 0.0;
        float cut = from_above != to_above ? a / (a - b) : 0.0;
        float begin = from_above ? 0.0 : cut, end = to_above ? 1.0 : cut;
        c.from[i] = corners[i] + edge * begin;
        c.edge[i] = edge * (from_above || to_above ? end - begin : 0.0);
        vec3 crossing = vec3((corners[i] + edge * cut).xy, 0.0);
        if (from_above && !to_above) leaves = crossing;
        if (!from_above && to_above) returns = crossing;
    }
    c.from[4] = leaves;
    c.edge[4] = returns - leaves;
    return c;
}

/// atan(x) for x in [0, 1], to 1.5e-7: a device's own may have no more than four digits. Interpolates atan(x) / x at
/// Chebyshev's points in x^2.
float atan_unit(float x)
{
    float u = x * x;
    float p = -0.00455979199;
    p = p * u + 0.0237805186;
    p = p * u - 0.0588297531;
    p = p * u + 0.0986886546;
    p = p * u - 0.140032902;
    p = p * u + 0.199669618;
    p = p * u - 0.333318127;
    p = p * u + 0.999999882;
    return p * x;
}

/// One edge of the polygon's irradiance integral: its angle times its axis' share along z. Where the polygon is small,
/// the edges nearly cancel, so each has to be exact to the last digits.
float edge_integral(vec3 from, vec3 edge)
{
    vec3 to = from + edge, axis = cross(from, edge);
    float s2 = dot(axis, axis);
    if (s2 <= 0.0) return 0.0;
    float s = sqrt(s2), c = dot(from, to);
    float half_angle = atan_unit(s / (sqrt(dot(from, from) * dot(to, to)) + abs(c))); // or that of what is left to pi
    return (c >= 0.0 ? 2.0 * half_angle : brdf_pi - 2.0 * half_angle) * axis.z / s;
}

/// Cosine-weighted share of the hemisphere, 0 to 1, that the rectangle covers.
float form_factor(ClippedRect c)
{
    float sum = 0.0;
    for (int i = 0; i < 5; ++i) sum += edge_integral(c.from[i], c.edge[i]);
    return abs(sum) / (2.0 * brdf_pi);
}

/// Share of the lobe, 0 to 1, that the rectangle covers.
float lobe_share(ClippedRect c, LtcLobe m)
{
    float sum = 0.0;
    for (int i = 0; i < 5; ++i) sum += edge_integral(cosine_of(m, c.from[i]), cosine_of(m, c.edge[i]));
    return abs(sum) / (2.0 * brdf_pi);
}

/// The table between its entries.
LtcLobe ltc_lobe(Brdf b)
{
    float last = float(ltc_size - 1u), alpha = sqrt(b.alpha2);
    float row = clamp((sqrt(alpha) - ltc_rough_min) * (last / (1.0 - ltc_rough_min)), 0.0, last);
    float column = min(sqrt(b.n_v), 1.0) * last;
    uint i = min(uint(row), ltc_size - 2u), j = min(uint(column), ltc_size - 2u);
    float s = row - float(i), t = column - float(j);
    float weights[4] = float[]((1.0 - s) * (1.0 - t), (1.0 - s) * t, s * (1.0 - t), s * t);
    vec3 shape = vec3(0.0);
    LtcLobe m;
    m.albedo = vec2(0.0);
    for (uint k = 0u; k < 4u; ++k) {
        LtcEntry e = ltc_table[(i + k / 2u) * ltc_size + j + k % 2u];
        shape += weights[k] * vec3(e.log2_along, e.log2_across, e.skew);
        m.albedo += weights[k] * vec2(e.albedo, e.fresnel);
    }
    float inv_narrow = 0.5 / alpha;
    m.inv_along = exp2(-shape.x) * inv_narrow * b.n_v * b.n_v;
    m.inv_across = exp2(-shape.y) * inv_narrow;
    m.skew = shape.z * sqrt(max(1.0 - b.n_v * b.n_v, 0.0)) / b.n_v;
    return m;
}

/// 1 - sin(atan t), without cancellation where t is large.
float co_sine(float t)
{
    float s = sqrt(1.0 + t * t);
    return t > 0.0 ? 1.0 / (s * (s + t)) : 1.0 - t / s;
}

/// Part of a line: where a point falls on it when the points are spread as evenly as the angles they are seen under.
struct Spread {
    float middle, scale, flip; // coordinate of the foot of the perpendicular; its distance in coordinates; 1 or -1
    float low, high;           // ends, as co_sine
};

Spread spread(float begin, float end, float middle, float scale)
{
    float flip = begin + end < 2.0 * middle ? -1.0 : 1.0; // most of it lies where co_sine is exact
    float inv = flip / scale;
    return Spread(middle, scale, flip, co_sine((begin - middle) * inv), co_sine((end - middle) * inv));
}

/// Point at x in [-1, 1]: its coordinate, its tangent from the foot, 1 + tangent^2, and the length that dx covers.
struct SpreadPoint {
    float at, tangent, secant2, width;
};

SpreadPoint spread_point(Spread s, float x)
{
    float c = 0.5 * (s.low + s.high) + 0.5 * (s.high - s.low) * x;
    float secant2 = 1.0 / max(c * (2.0 - c), 1e-12), secant = sqrt(secant2), tangent = (1.0 - c) * secant;
    return SpreadPoint(s.middle + s.flip * s.scale * tangent, tangent, secant2,
                       0.5 * abs(s.high - s.low) * s.scale * secant2 * secant);
}

// Gauss and Legendre's points and weights in [0, 1] for 2, 4, 6 and 8 points; the others lie at -x.
const vec2 gauss[10] = vec2[](vec2(0.5773502692, 1.0), vec2(0.3399810436, 0.6521451549),
                              vec2(0.8611363116, 0.3478548451), vec2(0.2386191861, 0.4679139346),
                              vec2(0.6612093865, 0.3607615730), vec2(0.9324695142, 0.1713244924),
                              vec2(0.1834346425, 0.3626837834), vec2(0.5255324099, 0.3137066459),
                              vec2(0.7966664774, 0.2223810345), vec2(0.9602898565, 0.1012285363));

vec2 gauss_point(int count, int i)
{
    int half_count = count / 2;
    vec2 p = gauss[half_count * (half_count - 1) / 2 + i / 2];
    return (i & 1) == 0 ? p : vec2(-p.x, p.y);
}

/// How many points a line needs: what covers little of the sphere is even enough for few.
int points_on(Spread s, int most)
{
    float length = abs(s.high - s.low);
    return length < 0.1 ? 2 : length < 0.4 ? 4 : most;
}

/// Sums over at most most^2 points of the rectangle: xy the integral of D V n.l, for F = 1 and F = (1 - v.h)^5; z the
/// share of the lobe that the same points give. They are spread evenly over what the rectangle covers of the sphere on
/// which the lobe is a cosine.
vec3 sum_points(LocalRect r, LtcLobe m, Brdf b, int most)
{
    // Lines run along the side that looks longer to the cosine, so that the fewer steps are the shorter ones.
    vec3 u = r.right, w = r.up;
    vec3 cosine_c = cosine_of(m, r.centre), cosine_u = cosine_of(m, u), cosine_w = cosine_of(m, w);
    if (dot(cosine_u, cosine_u) > dot(cosine_w, cosine_w)) {
        u = r.up;
        w = r.right;
        cosine_u = cosine_of(m, u);
        cosine_w = cosine_of(m, w);
    }
    vec3 v = vec3(-sqrt(max(1.0 - b.n_v * b.n_v, 0.0)), 0.0, b.n_v);
    float w2 = dot(cosine_w, cosine_w), inv_w = inversesqrt(w2);
    vec3 c = cosine_c - cosine_w * (dot(cosine_c, cosine_w) / w2);
    vec3 d = cosine_u - cosine_w * (dot(cosine_u, cosine_w) / w2);
    float d2 = max(dot(d, d), 1e-30), middle = -dot(c, d) / d2;
    vec3 nearest = c + d * middle;
    float h = sqrt(max(dot(nearest, nearest), 1e-20)); // distance of the rectangle's plane from the eye of the cosine

    // Points (s, t) in [-1, 1]^2 above the horizon: z + s u.z + t w.z > 0.
    float top = r.centre.z + abs(w.z), s_cut = u.z != 0.0 ? -top / u.z : -2.0;
    float first = u.z > 0.0 ? max(s_cut, -1.0) : -1.0, last = u.z < 0.0 ? min(s_cut, 1.0) : 1.0;
    if (first >= last || u.z == 0.0 && top <= 0.0) return vec3(0.0);
    Spread rows = spread(first, last, middle, h * inversesqrt(d2));
    float plane = abs(dot(cross(u, w), r.centre));
    float lobe_factor = plane * m.inv_along * m.inv_across / brdf_pi;

    vec3 sum = vec3(0.0);
    int row_count = points_on(rows, most);
    for (int i = 0; i < row_count; ++i) {
        vec2 node = gauss_point(row_count, i);
        SpreadPoint row = spread_point(rows, node.x);
        vec3 p = r.centre + u * row.at;
        float t_cut = w.z != 0.0 ? -p.z / w.z : -2.0;
        float begin = w.z > 0.0 ? max(t_cut, -1.0) : -1.0, end = w.z < 0.0 ? min(t_cut, 1.0) : 1.0;
        if (begin >= end || w.z == 0.0 && p.z <= 0.0) continue;
        float h_row2 = h * h * row.secant2, row_weight = node.y * row.width;
        Spread line = spread(begin, end, -dot(cosine_c + cosine_u * row.at, cosine_w) / w2, sqrt(h_row2) * inv_w);
        int count = points_on(line, most);
        for (int k = 0; k < count; ++k) {
            vec2 point = gauss_point(count, k);
            SpreadPoint at = spread_point(line, point.x);
            vec3 q = p + w * at.at;
            float inv_q = inversesqrt(dot(q, q)), weight = row_weight * point.y * at.width, z = max(q.z, 0.0);
            float q2 = h_row2 * at.secant2; // squared length of the point's cosine
            vec3 l = q * inv_q, half_l = l + v;
            float inv_h2 = 1.0 / max(dot(half_l, half_l), 1e-8), n_l = z * inv_q;
            vec2 f = brdf_specular_parts(b, n_l, half_l.z * half_l.z * inv_h2, dot(half_l.xy, half_l.xy) * inv_h2,
                                         (1.0 + dot(v, l)) * sqrt(inv_h2));
            sum += weight * vec3(f * (n_l * plane * inv_q * inv_q * inv_q), lobe_factor * z / (q2 * q2));
        }
    }
    return sum;
}

/// Integral of the specular lobe times n.l over the rectangle, for F = 1 and for F = (1 - v.h)^5.
vec2 rect_specular(LocalRect r, ClippedRect c, Brdf b)
{
    LtcLobe m = ltc_lobe(b);
    float share = lobe_share(c, m);
    // A cosine follows the lobe of a rough surface badly near the horizon, where that ends abruptly; the more so the
    // lower the eye. The points tell what the cosine lacks, and it tells what the points missed.
    vec3 sum = sum_points(r, m, b, b.n_v > 0.4 ? 4 : b.n_v > 0.2 ? 6 : 8);
    if (sum.z <= 0.0) return share * m.albedo;
    if (sum.z >= share) return sum.xy * (min(share + 2e-6, sum.z) / sum.z); // the share may be off by so much
    return sum.xy + (share - sum.z) * min(sum.xy / sum.z, m.albedo);
}

#endif
