// Unit vectors on the unfolded octahedron. C++ twin: renderer/scene/vertex_packing.hpp.
// Source: Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors".
#ifndef OCTAHEDRAL_GLSL
#define OCTAHEDRAL_GLSL

vec2 sign_not_zero(vec2 v) { return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0); }

/// Unit vector to [-1,1]^2.
vec2 oct_encode(vec3 n)
{
    vec2 e = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    return n.z < 0.0 ? (1.0 - abs(e.yx)) * sign_not_zero(e) : e;
}

vec3 oct_decode(vec2 e)
{
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    float fold = max(-n.z, 0.0);
    n.xy -= sign_not_zero(n.xy) * fold;
    return normalize(n);
}

/// The largest number that fields of so many bits are used for: even, for then 0 is among the coordinates, and normals along
/// the axes, which most large planes have, come back exact.
uint oct_top(uint bits) { return (1u << bits) - 2u; }

/// Two unsigned fixed-point fields of `bits` bits each, x in the low ones.
uint oct_pack(vec3 n, uint bits)
{
    float top = float(oct_top(bits));
    uvec2 q = uvec2(ivec2((oct_encode(n) * 0.5 + 0.5) * top + 0.5)); // signed: CPUs convert no unsigned numbers
    return q.x | (q.y << bits);
}

vec3 oct_unpack(uint packed, uint bits)
{
    uint mask = (1u << bits) - 1u;
    return oct_decode(vec2(ivec2(packed & mask, (packed >> bits) & mask)) * (2.0 / float(oct_top(bits))) - 1.0);
}

/// A vertex tangent: x 16 bits, y 15 bits, bit 31 the handedness. Returns (tangent, w).
vec4 tangent_unpack(uint packed)
{
    vec2 e = vec2(float(packed & 0xffffu) * (2.0 / 65535.0), float((packed >> 16) & 0x7fffu) * (2.0 / 32767.0)) - 1.0;
    return vec4(oct_decode(e), (packed >> 31) != 0u ? -1.0 : 1.0);
}

#endif
