// Packing of the G-buffer. Its layout: renderer/techniques/gbuffer/README.md.
#ifndef GBUFFER_PACKING_GLSL
#define GBUFFER_PACKING_GLSL
#include "lib/octahedral.glsl"

uint unorm8(float x) { return uint(int(clamp(x, 0.0, 1.0) * 255.0 + 0.5)); }

/// Dielectric F0 in 8 bits, finer towards 0: F0 = (k / 255)^2 / 4; 0.04 is exact.
uint pack_specular(float f0) { return unorm8(2.0 * sqrt(max(f0, 0.0))); }
float unpack_specular(uint k) { float s = float(k) / 255.0; return 0.25 * s * s; }

uvec2 pack_normals(vec3 normal, vec3 geometric_normal, float roughness)
{
    return uvec2(oct_pack(normal, 16u), oct_pack(geometric_normal, 12u) | (unorm8(roughness) << 24));
}

/// 0 is the background.
uint pack_id(uint record, float specular) { return pack_specular(specular) | ((record + 1u) << 8); }
bool is_background(uint id) { return id < 256u; }

#endif
