// Noise by pixel.
#ifndef NOISE_GLSL
#define NOISE_GLSL

/// 0 to 1 by whole pixel; any 3x3 pixels hold about evenly spread values. Source: Jimenez 2014, "Next Generation Post
/// Processing in Call of Duty: Advanced Warfare".
float interleaved_gradient_noise(vec2 pixel)
{
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
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
