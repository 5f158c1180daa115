#version 460
// Shader functions over a table of cases, for comparison with their C++ twins.
#extension GL_GOOGLE_include_directive : require
#include "lib/brdf.glsl"
#include "lib/color.glsl"
#include "lib/gbuffer_packing.glsl"
#include "lib/dispatch.glsl"
#include "lib/pass.glsl"

#extension GL_EXT_scalar_block_layout : require

struct Case {
    vec3 direction;
    float roughness;
    vec3 color;
    float metallic;
    float n_v, n_l, v_l;
    float specular;
};
struct Result {
    vec3 normal16;
    uint packed16;
    vec3 normal12;
    uint packed_color;
    vec3 color;
    float specular;
    vec3 brdf;
    uint packed_specular;
    vec3 aces;
    float unused;
};

layout(local_size_x = 64) in;
layout(PASS_BUFFER(0), scalar) readonly buffer Cases { Case cases[]; };
layout(PASS_BUFFER(1), scalar) writeonly buffer Results { Result results[]; };

void main()
{
    uint i = INVOCATION_INDEX;
    if (i >= cases.length()) return;
    Case c = cases[i];
    Result r;
    r.packed16 = oct_pack(c.direction, 16u);
    r.normal16 = oct_unpack(r.packed16, 16u);
    r.normal12 = oct_unpack(oct_pack(c.direction, 12u), 12u);
    r.packed_color = pack_rgb9e5(c.color);
    r.color = unpack_rgb9e5(r.packed_color);
    r.packed_specular = pack_specular(c.specular);
    r.specular = unpack_specular(r.packed_specular);
    r.brdf = brdf_evaluate(make_brdf(c.color, c.metallic, c.roughness, c.specular, c.n_v), c.n_l, c.v_l);
    r.aces = tonemap_aces(c.color);
    r.unused = 0.0;
    results[i] = r;
}
