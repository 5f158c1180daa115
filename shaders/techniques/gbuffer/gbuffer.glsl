// Fragment stage of the G-buffer pass, after a material class has been included.
#include "lib/color.glsl"
#include "lib/gbuffer_packing.glsl"

layout(location = 0) in vec4 v_offset_u;
layout(location = 1) in vec4 v_normal_v;
layout(location = 2) in vec4 v_tangent;
layout(location = 3) in vec3 v_prev_clip;
layout(location = 4) flat in uvec4 v_factors;
layout(location = 5) flat in uvec3 v_slots;

layout(location = 0) out vec4 out_albedo;
layout(location = 1) out uvec2 out_normal;
layout(location = 2) out uint out_id;
layout(location = 3) out uint out_emission;
layout(location = 4) out vec2 out_motion;

void main()
{
    Material material = unpack_material(v_factors, v_slots.xy, v_slots.z);
    vec2 texture_uv = vec2(v_offset_u.w, v_normal_v.w);
    SurfaceSample s = surface(material, SurfacePoint(v_normal_v.xyz, v_tangent, texture_uv, gl_FrontFacing));

    // The triangle's plane, from positions that lie in it exactly; y of the window points down.
    vec3 offset = v_offset_u.xyz;
    vec3 plane = cross(dFdx(offset), dFdy(offset));
    vec3 geometric_normal = normalize(dot(plane, offset) > 0.0 ? -plane : plane);

    vec2 uv = gl_FragCoord.xy * frame.inv_size;
    vec2 prev_uv = vec2(0.5, -0.5) * v_prev_clip.xy / v_prev_clip.z + 0.5;

    out_albedo = vec4(s.base_color, s.metallic);
    out_normal = pack_normals(s.normal, geometric_normal, s.roughness);
    out_id = pack_id(v_slots.z & 0xffffffu, s.specular);
    out_emission = pack_rgb9e5(s.emission * frame.exposure);
    out_motion = v_prev_clip.z > 0.0 ? uv - prev_uv : vec2(0.0);
}
