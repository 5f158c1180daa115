// Vertices of the scene into a face of a shadow map.
#include "materials/vertex.glsl"
#include "shared/shadow.h"

layout(push_constant, scalar) uniform Push { ShadowDrawPush push; };

/// Clip-space position of a world-space point in the tile's projection.
vec4 shadow_position(vec3 world_point)
{
    vec4 world = vec4(world_point, 1.0);
    vec3 p = vec3(dot(push.face.x, world), dot(push.face.y, world), dot(push.face.z, world));
    if (push.perspective != 0u) return vec4(p.xy, push.depth_scale, p.z);
    return vec4(p.xy, 1.0 - p.z / push.depth_scale, 1.0);
}
