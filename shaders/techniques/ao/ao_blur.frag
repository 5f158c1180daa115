#version 460
// The mean over 4 x 4 texels, in which the noise of each method takes every value once, of those that lie in the same
// surface.
#extension GL_GOOGLE_include_directive : require
#include "techniques/ao/ao.glsl"

layout(PASS_IMAGE(2)) uniform texture2D raw;
layout(location = 0) out vec2 out_ao;

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec2 own = texelFetch(raw, texel, 0).xy;
    out_ao = own;
    if (own.y == no_surface) return;
    ivec2 last = textureSize(raw, 0) - 1, pixel = pixel_of(texel);
    vec3 p = ray_of(pixel) * own.y, n = plane_normal(pixel);
    float sum = own.x, weights = 1.0;
    for (int y = -2; y < 2; ++y) {
        for (int x = -2; x < 2; ++x) {
            ivec2 other = texel + ivec2(x, y);
            if (x == 0 && y == 0) continue;
            other += 4 * (ivec2(lessThan(other, ivec2(0))) - ivec2(greaterThan(other, last))); // as noisy, in the picture
            vec2 q = texelFetch(raw, other, 0).xy;
            if (q.y == no_surface) continue;
            float w = plane_weight(p, n, ray_of(pixel_of(other)) * q.y);
            sum += w * q.x;
            weights += w;
        }
    }
    out_ao.x = finished(sum / weights);
}
