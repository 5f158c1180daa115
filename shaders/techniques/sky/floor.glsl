// The plane below the scene: where it is seen.
#include "lib/frame.glsl"
#include "lib/pass.glsl"
#include "shared/sky.h"

layout(push_constant, scalar) uniform Push { FloorPush push; };

const float fade_begin = 3.0, fade_end = 14.0; // of push.radius from the middle: where the floor becomes the horizon

/// How much of the floor is left at a point of it, 1 to 0.
float floor_share(vec3 p) { return 1.0 - smoothstep(fade_begin, fade_end, length(p.xz - push.middle.xz) / push.radius); }

/// Distance along the view axis, m, to the floor; 0: a ray does not meet it where it is to be seen.
float floor_distance(vec3 ray)
{
    float z = (push.middle.y - frame.eye.y) / min(ray.y, -1e-20);
    return ray.y < 0.0 && floor_share(frame.eye + z * ray) > 0.0 ? z : 0.0;
}
