// Colour: sRGB, shared-exponent packing and tone operators. Linear Rec.709 throughout.
#ifndef COLOR_GLSL
#define COLOR_GLSL

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

/// Linear from sRGB-encoded. Source: IEC 61966-2-1.
vec3 srgb_decoded(vec3 c)
{
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}

/// The inverse.
vec3 srgb_encoded(vec3 c)
{
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

/// Three 9-bit mantissas and a 5-bit exponent, 0 to 65408. Source: EXT_texture_shared_exponent.
uint pack_rgb9e5(vec3 c)
{
    c = clamp(c, vec3(0.0), vec3(65408.0));
    float top = max(c.r, max(c.g, c.b));
    if (top == 0.0) return 0u;
    int exponent = max(-16, int(floor(log2(top)))) + 16;
    float unit = exp2(float(exponent - 24));
    if (floor(top / unit + 0.5) == 512.0) { // rounds up into the next exponent
        unit *= 2.0;
        exponent += 1;
    }
    uvec3 m = uvec3(ivec3(c / unit + 0.5));
    return m.r | (m.g << 9) | (m.b << 18) | (uint(exponent) << 27);
}

vec3 unpack_rgb9e5(uint p)
{
    if (p == 0u) return vec3(0.0);
    return vec3(p & 511u, (p >> 9) & 511u, (p >> 18) & 511u) * exp2(float(int(p >> 27) - 24));
}

/// Fitted ACES reference and output transforms. Source: Stephen Hill 2015. Matrices are written by rows and transposed.
vec3 tonemap_aces(vec3 c)
{
    const mat3 input_transform = transpose(mat3(0.59719, 0.35458, 0.04823, 0.07600, 0.90834, 0.01566, 0.02840, 0.13383, 0.83777));
    const mat3 output_transform = transpose(mat3(1.60475, -0.53108, -0.07367, -0.10208, 1.10813, -0.00605, -0.00327, -0.07276, 1.07602));
    vec3 v = input_transform * c;
    v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    return output_transform * v;
}

#endif
