// Gathering minimum, maximum and sum.
#ifndef STATISTICS_GLSL
#define STATISTICS_GLSL
#include "shared/buffer_view.h"

const float infinity = 1.0 / 0.0;

BufferStatistics no_statistics() { return BufferStatistics(infinity, -infinity, 0.0, 0u, vec2(0.0)); }

BufferStatistics combined(BufferStatistics a, BufferStatistics b)
{
    return BufferStatistics(min(a.low, b.low), max(a.high, b.high), a.sum + b.sum, a.count + b.count, vec2(0.0));
}

/// By its bits: compilers may take every float for a number.
bool is_finite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }

#endif
