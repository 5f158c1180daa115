#version 460
// Exposed radiance to display colour, linear Rec.709 in [0, 1]; the sRGB target encodes it once.
#extension GL_GOOGLE_include_directive : require
#include "lib/color.glsl"
#include "lib/pass.glsl"
#include "shared/tonemap.h"

layout(constant_id = 0) const uint tone_operator = tonemap_operator_aces;
layout(PASS_IMAGE(0)) uniform texture2D hdr; // radiance x exposure
layout(location = 0) out vec4 out_color;

void main()
{
    vec3 c = max(texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb, vec3(0.0));
    if (tone_operator == tonemap_operator_aces) c = tonemap_aces(c);
    out_color = vec4(clamp(c, 0.0, 1.0), 1.0);
}
