#version 460
// Second half of occlusion culling: holds every cluster against the depth of those already drawn, draws what the first
// half missed, and remembers what was seen for the next frame.
#extension GL_GOOGLE_include_directive : require
#include "techniques/culling/culling.glsl"

layout(PASS_BUFFER(1), scalar) buffer Seen { uint seen[]; }; // by task
layout(PASS_BUFFER(2), scalar) readonly buffer Pyramid { float pyramid[]; };
layout(push_constant, scalar) uniform Push { LateCullPush push; };

const uint widest = 8; // cells of a level along the side of a sphere's rectangle: more cost time, fewer hide less

/// Tangents of the directions between which a circle lies: centre (x, z) from the eye, z > radius.
/// Source: Mara, McGuire 2013, "2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere", JCGT.
vec2 tangent_range(float x, float z, float radius)
{
    float t = sqrt(x * x + z * z - radius * radius);
    return vec2((t * x - radius * z) / (t * z + radius * x), (t * x + radius * z) / (t * z - radius * x));
}

/// Whether all that was drawn under the sphere lies in front of it.
bool hidden(ClusterSphere s)
{
    vec3 centre = vec3(dot(s.d, frame.right), dot(s.d, frame.up), dot(s.d, frame.forward));
    if (centre.z - s.radius <= frame.near) return false;
    vec2 x = tangent_range(centre.x, centre.z, s.radius) / frame.tan_x;
    vec2 y = tangent_range(centre.y, centre.z, s.radius) / frame.tan_y;
    vec2 low = (vec2(x.x, -y.y) * 0.5 + 0.5) * frame.size, high = (vec2(x.y, -y.x) * 0.5 + 0.5) * frame.size;
    ivec2 last_pixel = ivec2(frame.size) - 1;
    ivec2 from = clamp(ivec2(floor(low)), ivec2(0), last_pixel), to = clamp(ivec2(floor(high)), ivec2(0), last_pixel);

    uint level = 0u;
    int side = int(pyramid_base);
    while (level + 1u < pyramid_levels && any(greaterThanEqual(to / side - from / side, ivec2(widest)))) {
        ++level;
        side *= int(pyramid_step);
    }
    float nearest = 1.0001 * frame.near / (centre.z - s.radius); // a little nearer: rasterised depth is rounded
    for (int cy = from.y / side; cy <= to.y / side; ++cy) {
        for (int cx = from.x / side; cx <= to.x / side; ++cx) {
            uint cell = push.levels[level].first + uint(cy) * push.levels[level].cells.x + uint(cx);
            if (pyramid[cell] <= nearest) return false;
        }
    }
    return true;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= push.cull.count) return;
    uint index = order_table[i];
    DrawTask task = task_table[index];
    ClusterSphere sphere = sphere_of(task);
    bool visible = may_be_seen(task, sphere, push.cull.flags) && !hidden(sphere);
    write_command(i, task, visible && seen[index] == 0u);
    seen[index] = visible ? 1u : 0u;
}
