#version 460
// EASU, the enlarging pass of FSR 1: each pixel is a weighted mean of 12 pixels of the source. The weights are those of a
// Lanczos-like kernel, turned along the edge that runs through the pixel and stretched by the edge's strength.
// Source: Lottes & AMD 2021, "FidelityFX Super Resolution 1.0".
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "shared/upscale.h"
#include "techniques/upscale/approximate.glsl"

layout(push_constant, scalar) uniform Push { UpscalePush push; };
layout(PASS_IMAGE(0)) uniform texture2D source; // encoded for display, 0 to 1
layout(location = 0) out vec4 out_color;

/// The quotient of a byte and 255, correctly rounded.
vec3 exact(vec3 c)
{
    precise vec3 q = round(c * 255.0) / 255.0;
    return q;
}

/// Twice the luma, of weights that are cheap. Where colours of equal luma meet, the rounding of this sum decides whether
/// there is an edge: the order of its terms is part of the result.
float luma(vec3 c)
{
    precise float sum = (c.g + 0.5 * c.r) + 0.5 * c.b;
    return sum;
}

// The edge at the pixel: its direction across (not normalised) and its strength, 0 to 2, summed over four neighbours.
struct Edge {
    vec2 across;
    float strength;
};

/// How well three values in a row make a ramp: 1 on a ramp, 0 on a line one pixel wide.
float ramp(float before, float middle, float after)
{
    float steepest = max(abs(after - middle), abs(middle - before));
    float r = clamp(abs(after - before) * coarse_reciprocal(steepest), 0.0, 1.0);
    return r * r;
}

/// Adds what one source pixel and its four neighbours say of the edge.
void add_neighbour(inout Edge edge, float share, float up, float left, float middle, float right, float down)
{
    edge.across += share * vec2(right - left, down - up);
    edge.strength += share * (ramp(left, middle, right) + ramp(up, middle, down));
}

// The kernel of a pixel: coordinates across and along the edge are scaled, and its window has this width.
struct Shape {
    vec2 across;
    float scale_across, scale_along, window, limit;
};

Shape shape_of(Edge edge)
{
    Shape s;
    float squared = dot(edge.across, edge.across);
    s.across = squared < 1.0 / 32768.0 ? vec2(1.0, edge.across.y) : edge.across * coarse_inverse_sqrt(squared);
    float strength = 0.25 * edge.strength * edge.strength;
    // About 1 along an axis and sqrt(2) on a diagonal, where pixels are farther apart.
    float apart = dot(s.across, s.across) * coarse_reciprocal(max(abs(s.across.x), abs(s.across.y)));
    s.scale_across = 1.0 + (apart - 1.0) * strength;
    s.scale_along = 1.0 - 0.5 * strength;
    s.window = 0.5 - 0.29 * strength;
    s.limit = coarse_reciprocal(s.window); // of the squared distance: beyond it the polynomial would rise again
    return s;
}

/// Weight of a source pixel at `offset` from the target pixel. A polynomial approximates Lanczos 2.
float weight(Shape s, vec2 offset)
{
    float across = s.scale_across * dot(offset, s.across);
    float along = s.scale_along * (offset.y * s.across.x - offset.x * s.across.y);
    float d = min(across * across + along * along, s.limit);
    float base = 0.4 * d - 1.0, window = s.window * d - 1.0;
    return (25.0 / 16.0 * base * base - 9.0 / 16.0) * (window * window);
}

void main()
{
    vec2 position = floor(gl_FragCoord.xy) * push.scale + push.offset;
    vec2 whole = floor(position), t = position - whole;
    ivec2 last = textureSize(source, 0) - 1, c[4];
    for (int i = 0; i < 4; ++i) c[i] = clamp(ivec2(whole) + i - 1, ivec2(0), last);
    // The pixels around: 4 x 4 without the corners.
    //      b c
    //    e f g h        f is at `whole`
    //    i j k l
    //      n o
#define FETCH(column, row) exact(texelFetch(source, ivec2(c[column].x, c[row].y), 0).rgb)
    vec3 b = FETCH(1, 0), cc = FETCH(2, 0);
    vec3 e = FETCH(0, 1), f = FETCH(1, 1), g = FETCH(2, 1), h = FETCH(3, 1);
    vec3 i = FETCH(0, 2), j = FETCH(1, 2), k = FETCH(2, 2), l = FETCH(3, 2);
    vec3 n = FETCH(1, 3), o = FETCH(2, 3);

    float lb = luma(b), lc = luma(cc), le = luma(e), lf = luma(f), lg = luma(g), lh = luma(h);
    float li = luma(i), lj = luma(j), lk = luma(k), ll = luma(l), ln = luma(n), lo = luma(o);
    Edge edge = Edge(vec2(0.0), 0.0);
    add_neighbour(edge, (1.0 - t.x) * (1.0 - t.y), lb, le, lf, lg, lj);
    add_neighbour(edge, t.x * (1.0 - t.y), lc, lf, lg, lh, lk);
    add_neighbour(edge, (1.0 - t.x) * t.y, lf, li, lj, lk, ln);
    add_neighbour(edge, t.x * t.y, lg, lj, lk, ll, lo);
    Shape shape = shape_of(edge);

    vec3 sum = vec3(0.0);
    float weights = 0.0;
#define TAP(color, x, y)                                                                                               \
    {                                                                                                                  \
        float w = weight(shape, vec2(x, y) - t);                                                                       \
        sum += w * color;                                                                                              \
        weights += w;                                                                                                  \
    }
    TAP(b, 0.0, -1.0)
    TAP(cc, 1.0, -1.0)
    TAP(e, -1.0, 0.0)
    TAP(f, 0.0, 0.0)
    TAP(g, 1.0, 0.0)
    TAP(h, 2.0, 0.0)
    TAP(i, -1.0, 1.0)
    TAP(j, 0.0, 1.0)
    TAP(k, 1.0, 1.0)
    TAP(l, 2.0, 1.0)
    TAP(n, 0.0, 2.0)
    TAP(o, 1.0, 2.0)
    // No value outside those of the four pixels around: no ringing.
    out_color = vec4(clamp(sum / weights, min(min(f, g), min(j, k)), max(max(f, g), max(j, k))), 1.0);
}
