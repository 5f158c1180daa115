#version 460
// The user interface's colours, sRGB-encoded as they stand.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "lib/textures.glsl"
#include "shared/ui.h"

layout(PASS_IMAGE(0)) uniform texture2D font; // coverage in alpha
layout(PASS_IMAGE(1)) uniform texture2D insets;
layout(push_constant, scalar) uniform Push { UiPush push; };
layout(location = 0) in vec2 in_uv;
layout(location = 1) in vec4 in_color;
layout(location = 0) out vec4 out_color;

void main()
{
    vec4 texel = push.image == ui_insets
                     ? vec4(textureLod(sampler2D(insets, samplers[sampler_linear_clamp]), in_uv, 0.0).rgb, 1.0)
                     : textureLod(sampler2D(font, samplers[sampler_linear_clamp]), in_uv, 0.0);
    out_color = in_color * texel;
}
