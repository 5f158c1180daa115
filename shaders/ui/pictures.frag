#version 460
// A window's pictures, sRGB-encoded as they stand.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "lib/textures.glsl"
#include "shared/ui.h"

layout(constant_id = 0) const uint texel_by_texel = 0u; // the pictures have the window's size
layout(PASS_IMAGE(0)) uniform texture2D main_picture;
layout(PASS_IMAGE(1)) uniform texture2D other_picture;
layout(push_constant, scalar) uniform Push { PicturesPush push; };
layout(location = 0) out vec4 out_color;

vec3 read(texture2D picture)
{
    if (texel_by_texel != 0u) return texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
    return textureLod(sampler2D(picture, samplers[sampler_linear_clamp]), gl_FragCoord.xy * push.inv_size, 0.0).rgb;
}

void main()
{
    bool is_other = gl_FragCoord.x < push.divider;
    if (is_other)
        out_color = vec4(read(other_picture), 1.0);
    else
        out_color = vec4(read(main_picture), 1.0);
}
