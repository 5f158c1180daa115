#version 460
// A half-size AO image at full size: of the four texels around, those that lie in the pixel's own surface.
// Source: Kopf et al. 2007, "Joint Bilateral Upsampling".
#extension GL_GOOGLE_include_directive : require
#include "techniques/ao/ao.glsl"

layout(PASS_IMAGE(2)) uniform texture2D halves;
layout(location = 0) out float out_ao;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = fetch_depth(pixel);
    out_ao = 1.0;
    if (depth <= 0.0) return;
    vec3 p = ray_of(pixel) * view_distance(depth), n = plane_normal(pixel);
    // Texels stand for even pixels; blurred ones, means of two texels before and one after, for the odd pixels before.
    ivec2 place = pixel + int(push.blur), first = place / 2, last = textureSize(halves, 0) - 1;
    vec2 part = 0.5 * vec2(place & 1);
    float sum = 0.0, weights = 0.0, nearest = 1e30, fallback = 1.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i & 1, i >> 1), texel = min(first + step, last);
        vec2 q = texelFetch(halves, texel, 0).xy;
        if (q.y == no_surface) continue;
        vec3 at = ray_of(texel * 2) * q.y;
        vec2 share = mix(1.0 - part, part, vec2(step));
        float w = share.x * share.y * plane_weight(p, n, at), off = abs(dot(n, at - p));
        sum += w * q.x;
        weights += w;
        if (off < nearest) {
            nearest = off;
            fallback = q.x;
        }
    }
    out_ao = weights > 1e-3 ? sum / weights : fallback;
}
