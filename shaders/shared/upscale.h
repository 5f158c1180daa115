// Enlarging a picture.
#ifndef SHARED_UPSCALE_H
#define SHARED_UPSCALE_H
#include "types.h"
SHARED_BEGIN

/// Position in the source of the middle of target pixel p: p * scale + offset, where whole numbers are pixel middles.
struct UpscalePush {
    vec2 scale;
    vec2 offset;
};

struct SharpenPush {
    float strength; // 2^-stops
};

// Which filter resample.frag has.
const uint resample_bilinear = 0, resample_catmull_rom = 1, resample_lanczos = 2;

SHARED_END
#endif
