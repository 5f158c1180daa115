#version 460
// One light's layer of visibility.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"

layout(PASS_IMAGE(0)) uniform texture2DArray visibility;
layout(push_constant) uniform Push { uint layer; };
layout(location = 0) out float out_value;

void main() { out_value = texelFetch(visibility, ivec3(gl_FragCoord.xy, layer), 0).x; }
