// Noise by pixel.
#ifndef NOISE_GLSL
#define NOISE_GLSL

/// 0 to 1 by whole pixel; any 3x3 pixels hold about evenly spread values. Source: Jimenez 2014, "Next Generation Post
/// Processing in Call of Duty: Advanced Warfare".
float interleaved_gradient_noise(vec2 pixel)
{
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

/// 0 to 15, each once in every 4 x 4 texels, neighbours far apart. Source: Bayer 1973, "An Optimum Method for Two-Level
/// Rendition of Continuous-Tone Pictures".
uint bayer(ivec2 texel)
{
    uint x = uint(texel.x), y = uint(texel.y), d = x ^ y;
    return (d & 1u) << 3 | (y & 1u) << 2 | (d & 2u) | (y & 2u) >> 1;
}

/// The unit vector at so many turns, 0 to 1, exact to a thousandth: cheaper than sine and cosine. Two parabolas, and a
/// share of their squares.
vec2 unit_vector(float turns)
{
    vec2 x = fract(vec2(turns + 0.25, turns)) * 2.0 - 1.0; // half turns, -1 to 1, of sines
    vec2 y = -4.0 * x * (1.0 - abs(x));
    return y * (0.775 + 0.225 * abs(y));
}

#endif
