#version 460
// Draws what is in the view, does not face away and is not hidden by the occluders.
#extension GL_GOOGLE_include_directive : require
#include "techniques/culling/culling.glsl"

#define PYRAMID_BUFFER 1
#include "techniques/culling/depth_pyramid.glsl"

layout(push_constant, scalar) uniform Push { OcclusionPush push; };

/// Tangents of the directions between which a circle lies: centre (x, z) from the eye, z > radius.
/// Source: Mara, McGuire 2013, "2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere", JCGT.
vec2 tangent_range(float x, float z, float radius)
{
    float t = sqrt(x * x + z * z - radius * radius);
    return vec2((t * x - radius * z) / (t * z + radius * x), (t * x + radius * z) / (t * z - radius * x));
}

/// Of a cluster that comes before the near plane nothing is known.
uint occlusion_of(ClusterSphere s)
{
    vec3 centre = vec3(dot(s.d, frame.right), dot(s.d, frame.up), dot(s.d, frame.forward));
    if (centre.z - s.radius <= frame.near) return hides_part;
    vec2 x = tangent_range(centre.x, centre.z, s.radius) / frame.tan_x + frame.jitter.x;
    vec2 y = tangent_range(centre.y, centre.z, s.radius) / frame.tan_y + frame.jitter.y;
    vec2 low = (vec2(x.x, -y.y) * 0.5 + 0.5) * frame.size, high = (vec2(x.y, -y.x) * 0.5 + 0.5) * frame.size;
    return occlusion(push.levels, low, high, frame.near / (centre.z - s.radius), frame.near / (centre.z + s.radius));
}

void main()
{
    uint i = INVOCATION_INDEX;
    if (i >= push.cull.count) return;
    DrawTask task = task_table[order_table[i]];
    ClusterSphere sphere = sphere_of(task);
    uint hides = may_be_seen(task, sphere, push.cull.flags) ? occlusion_of(sphere) : hides_all;
    bool ask_triangles = hides == hides_part && (push.cull.flags & cull_single_triangles) != 0u;
    write_command(i, task, hides == hides_all ? 0u : ask_triangles ? instances_of_partly_hidden : 1u);
}
