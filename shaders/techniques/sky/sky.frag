#version 460
// Sky where no geometry was drawn.
#extension GL_GOOGLE_include_directive : require
#include "lib/sky.glsl"

layout(location = 0) out vec4 out_radiance;

void main() { out_radiance = vec4(sky_radiance(normalize(view_ray(gl_FragCoord.xy))), 1.0); }
