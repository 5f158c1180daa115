#version 460
// A corner of the user interface, pulled from a buffer.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "shared/ui.h"

layout(PASS_BUFFER(0), scalar) readonly buffer Vertices { UiVertex vertices[]; };
layout(push_constant, scalar) uniform Push { UiPush push; };
layout(location = 0) out vec2 out_uv;
layout(location = 1) out vec4 out_color;

void main()
{
    UiVertex v = vertices[gl_VertexIndex];
    out_uv = v.uv;
    out_color = unpackUnorm4x8(v.color);
    gl_Position = vec4(2.0 * v.position * push.inv_size * vec2(1.0, -1.0) + vec2(-1.0, 1.0), 0.0, 1.0);
}
