// The floor plane below the scene.
#include "lib/frame.glsl"
#include "lib/pass.glsl"
#include "shared/sky.h"

layout(push_constant, scalar) uniform Push { FloorPush push; };

// The floor fades to the horizon between these distances from the middle, in units of push.radius.
const float fade_begin = 3.0, fade_end = 14.0;

/// Weight of the floor at one of its points: 1 near the scene, 0 at the horizon.
float floor_share(vec3 p) { return 1.0 - smoothstep(fade_begin, fade_end, length(p.xz - push.middle.xz) / push.radius); }

/// Distance along the view axis, m, to the floor; 0: the ray does not hit it, or only where it has faded out.
float floor_distance(vec3 ray)
{
    float z = (push.middle.y - frame.eye.y) / min(ray.y, -1e-20);
    return ray.y < 0.0 && floor_share(frame.eye + z * ray) > 0.0 ? z : 0.0;
}
