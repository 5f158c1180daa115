#version 460
// The user interface's colours, sRGB-encoded as they stand.
#extension GL_GOOGLE_include_directive : require
#include "lib/color.glsl"
#include "lib/pass.glsl"
#include "lib/textures.glsl"
#include "shared/ui.h"

// What it reads is of the pipeline: lavapipe would read all three at each pixel and choose then.
layout(constant_id = 0) const uint kind = ui_font;
layout(PASS_IMAGE(0)) uniform texture2D font; // coverage in alpha
layout(PASS_IMAGE(1)) uniform texture2D insets;
layout(push_constant, scalar) uniform Push { UiPush push; };
layout(location = 0) in vec2 in_uv;
layout(location = 1) in vec4 in_color;
layout(location = 0) out vec4 out_color;

vec4 fetch(vec2 uv)
{
    if (kind == ui_plain) return vec4(1.0);
    if (kind == ui_font) return textureLod(sampler2D(font, samplers[sampler_linear_clamp]), uv, 0.0);
    if (kind == ui_insets)
        return vec4(textureLod(sampler2D(insets, samplers[sampler_linear_clamp]), uv, 0.0).rgb, 1.0);
    uint slot = push.image - ui_textures; // of a colour: reading it decodes
    return vec4(srgb_encoded(texture(sampler2D(textures[slot], samplers[sampler_material]), uv).rgb), 1.0);
}

void main() { out_color = in_color * fetch(in_uv); }
