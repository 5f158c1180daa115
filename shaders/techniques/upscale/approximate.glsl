// Approximate reciprocals from the bits of a float. Their errors are part of the result of FSR 1: with exact ones
// pictures differ by up to 73 of 255.

/// 1/a, -6.1 to +3.6 %. Finite for 0.
float coarse_reciprocal(float a) { return uintBitsToFloat(0x7EF07EBBu - floatBitsToUint(a)); }

/// 1/sqrt(a), -4.6 to +1.8 %.
float coarse_inverse_sqrt(float a) { return uintBitsToFloat(0x5F347D74u - (floatBitsToUint(a) >> 1)); }

/// 1/a, -0.32 to 0 %.
float medium_reciprocal(float a)
{
    float b = uintBitsToFloat(0x7EF19FFFu - floatBitsToUint(a));
    return b * (2.0 - b * a);
}
