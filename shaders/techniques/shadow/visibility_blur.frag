#version 460
// Takes the noise out of a light's visibility where its penumbra is wide in the picture. The 2 x 2 pixels that a device
// shades together read the 4 x 4 around, a quarter each, tell each other their sums, and lay a plane through what lies in
// their own surface: a mean that keeps slopes.
// Source: Tomasi, Manduchi 1998, "Bilateral Filtering"; James, Stein 1961, "Estimation with Quadratic Loss" (slopes).
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/pass.glsl"
#include "lib/textures.glsl"
#include "shared/shadow.h"

layout(PASS_IMAGE(0)) uniform texture2D raw; // visibility + 2 blur_…
layout(PASS_IMAGE(1)) uniform texture2D depth;
layout(PASS_IMAGE(2)) uniform utexture2D normal; // the G-buffer's
layout(location = 0) out float out_value;

vec2 outward; // from the middle of the four, -1 or 1 each way

// What another of the four holds.
vec4 beside(vec4 v) { return v - outward.x * dFdxFine(v); }
vec4 below(vec4 v) { return v - outward.y * dFdyFine(v); }
vec4 opposite(vec4 v) { return below(beside(v)); }
vec4 sum_of_four(vec4 v) { return v + beside(v) + below(v + beside(v)); }

// A pixel's quarter of the 4 x 4: the pixel beyond it in y, that in both, that in x, and itself.
const vec4 x = vec4(0.5, 1.5, 1.5, 0.5), y = vec4(1.5, 1.5, 0.5, 0.5); // how far from the middle they lie
vec2 quarter_place() { return (gl_FragCoord.xy + 0.5 * outward) * frame.inv_size; }
vec4 as_quarter(vec4 gathered)
{
    vec4 v = outward.x < 0.0 ? gathered.yxwz : gathered;
    return outward.y < 0.0 ? v.wzyx : v;
}
vec4 quarter(texture2D image)
{
    return as_quarter(textureGather(sampler2D(image, samplers[sampler_nearest_clamp]), quarter_place()));
}

/// Which of a quarter lie in the plane that the four make. Reversed depth is linear in pixels there.
vec4 in_plane()
{
    vec4 d = quarter(depth), sums = sum_of_four(vec4(d.w, d.w * outward, 0.0));
    float middle = 0.25 * sums.x, half_a_pixel = frame.tan_y * frame.inv_size.y * middle;
    vec2 slope = 0.5 * sums.yz;
    vec4 off = abs(d - middle - outward.x * slope.x * x - outward.y * slope.y * y);
    return vec4(lessThan(off, vec4(half_a_pixel + 0.1 * (abs(slope.x) + abs(slope.y)))));
}

/// Which of a quarter face as the pixel and its neighbours among the four do: behind a crease depths lie near the plane, too.
vec4 alike()
{
    const float most = 200.0; // of 4094: 6 degrees or more
    uvec4 packed = textureGather(usampler2D(normal, samplers[sampler_nearest_clamp]), quarter_place(), 1);
    vec4 u = as_quarter(vec4(ivec4(packed & 0xfffu))), v = as_quarter(vec4(ivec4(packed >> 12u & 0xfffu)));
    vec2 own = vec2(u.w, v.w), apart = max(abs(dFdxFine(own)), abs(dFdyFine(own)));
    return vec4(lessThan(max(max(abs(u - u.w), abs(v - v.w)), vec4(max(apart.x, apart.y))), vec4(most)));
}

void main()
{
    outward = vec2(ivec2(gl_FragCoord.xy) & 1) * 2.0 - 1.0;
    vec4 v = quarter(raw), blur = floor(0.5 * v);
    v -= 2.0 * blur;
    out_value = v.w;

    // The four do as the narrowest of them may, and nothing where all of the 4 x 4 are as bright.
    vec4 range = vec4(blur.w, min(min(v.x, v.y), min(v.z, v.w)), -max(max(v.x, v.y), max(v.z, v.w)), 0.0);
    range = min(range, beside(range));
    range = min(range, below(range));
    float least = range.x;
    if (least == blur_none || range.y == -range.z) return; // all four
    vec4 taken = vec4(greaterThanEqual(blur, vec4(least))) * in_plane() * alike();
    taken *= opposite(taken); // pairs, or what is missing on one side would pass for a slope
    if (least == blur_row) taken *= vec4(0, 0, 1, 1);
    if (least == blur_column) taken *= vec4(1, 0, 0, 1);

    vec4 own = vec4(dot(taken, vec4(1.0)), dot(taken, v), outward * vec2(dot(taken * x, v), dot(taken * y, v)));
    vec4 sums = sum_of_four(own); // of 1, v, x v, y v
    vec4 squares = sum_of_four(vec4(dot(taken, x * x), dot(taken, y * y), dot(taken, v * v), 0.0));
    if (taken.w == 0.0) return;

    // Slopes count as far as they stand out from those that noise alone would give; but all of one that nothing beyond the
    // four speaks for, as an edge of something may run between them.
    vec2 slope = sums.zw / squares.xy;
    float mean = sums.y / sums.x, by_slope = dot(slope, sums.zw);
    float noise = (squares.z - mean * sums.y - by_slope) / (sums.x - 3.0);
    vec2 kept = mix(vec2(1.0), vec2(max(1.0 - 4.0 * noise / max(by_slope, 1e-9), 0.0)), greaterThan(squares.xy, vec2(0.3 * sums.x)));
    out_value = clamp(mean + 0.5 * dot(kept * slope, outward), 0.0, 1.0);
}
