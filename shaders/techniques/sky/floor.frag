#version 460
// Depth and normal of the visible floor, for shadows and occlusion on it, and the depth of scene and floor together.
#extension GL_GOOGLE_include_directive : require
#include "lib/gbuffer_packing.glsl"
#include "techniques/sky/floor.glsl"

layout(PASS_IMAGE(0)) uniform texture2D scene_depth;
layout(location = 0) out float out_depth; // 0: no floor
layout(location = 1) out float out_whole_depth;
layout(location = 2) out uvec2 out_normal;

void main()
{
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).x, z = floor_distance(view_ray(gl_FragCoord.xy));
    out_depth = depth > 0.0 || z <= 0.0 ? 0.0 : frame.near / z;
    out_whole_depth = max(depth, out_depth);
    out_normal = pack_normals(vec3(0.0, 1.0, 0.0), vec3(0.0, 1.0, 0.0), 1.0);
}
