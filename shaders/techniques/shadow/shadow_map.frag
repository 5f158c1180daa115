#version 460
// A shadow map as distances along its faces' axes, m; infinite where nothing casts.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "shared/shadow.h"

layout(PASS_IMAGE(0)) uniform texture2D map;
layout(push_constant, scalar) uniform Push { ShadowMapPush push; };
layout(location = 0) out float out_distance;

void main()
{
    float depth = texelFetch(map, ivec2(gl_FragCoord.xy), 0).x;
    float z = push.perspective != 0u ? push.depth_scale / depth : (1.0 - depth) * push.depth_scale;
    out_distance = depth > 0.0 ? z : 1.0 / 0.0;
}
