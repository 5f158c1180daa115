// Vertices of the scene into a face of a shadow map.
#include "lib/scene.glsl"
#include "shared/shadow.h"

layout(push_constant, scalar) uniform Push { ShadowDrawPush push; };

vec4 shadow_position(vec3 position)
{
    vec4 world = vec4(transform_point(record_table[gl_BaseInstance].world_rows, position), 1.0);
    vec3 p = vec3(dot(push.face.x, world), dot(push.face.y, world), dot(push.face.z, world));
    if (push.perspective != 0u) return vec4(p.xy, push.depth_scale, p.z);
    return vec4(p.xy, 1.0 - p.z / push.depth_scale, 1.0);
}
