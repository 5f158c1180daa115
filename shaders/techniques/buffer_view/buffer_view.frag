#version 460
// Makes a picture of a buffer.
#extension GL_GOOGLE_include_directive : require
#include "lib/color.glsl"
#include "lib/pass.glsl"
#include "shared/viridis.h"
#include "techniques/buffer_view/picked.glsl"

layout(push_constant, scalar) uniform Push { BufferViewPush push; };
layout(PASS_IMAGE(0)) uniform texture2D source;
layout(PASS_BUFFER(0), scalar) readonly buffer Statistics { BufferStatistics statistics; };
layout(location = 0) out vec4 out_color;

/// Neighbouring indices get colours far apart. Source: golden-ratio hue steps.
vec3 index_color(float index)
{
    if (index < 0.0) return vec3(0.0);
    index = mod(index, 65536.0); // products with larger ones have too few bits behind the point
    float hue = fract(index * 0.61803399);
    vec3 c = clamp(abs(fract(hue + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return mix(vec3(1.0), c, 0.5 + 0.4 * fract(index * 0.381966)) * 0.8;
}

void main()
{
    vec3 v = picked(texelFetch(source, ivec2((gl_FragCoord.xy - push.origin) * push.texels), 0), push.pick);
    vec2 range = statistics.range;
    vec3 c = clamp((v - range.x) / (range.y - range.x), 0.0, 1.0);
    if (push.mode == view_scalar) c = c.rrr;
    if (push.mode == view_vector && v == vec3(0.0)) c = vec3(0.0);
    if (push.mode == view_index) c = index_color(v.r);
    if (push.mode == view_motion) c.b = 0.0;
    if (push.mode == view_viridis) c = srgb_decoded(viridis(c.r));
    out_color = vec4(c, 1.0);
}
