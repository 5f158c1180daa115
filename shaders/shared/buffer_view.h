// How a buffer is shown as a picture, and what is counted of it.
#ifndef SHARED_BUFFER_VIEW_H
#define SHARED_BUFFER_VIEW_H
#include "types.h"
SHARED_BEGIN

const uint view_color = 0, view_scalar = 1, view_vector = 2, view_index = 3, view_motion = 4, view_viridis = 5;

// What of a texel counts: one channel; red, green and blue each on its own, or their length; 0.
const uint pick_r = 0, pick_g = 1, pick_b = 2, pick_a = 3, pick_all = 4, pick_length = 5, pick_none = 6;

/// Of values that are finite.
struct BufferStatistics {
    float low, high, sum;
    uint count;
    vec2 range;         // shown: what is drawn darkest and brightest
};

const uint statistics_tile = 16;       // texels along its side
const uint statistics_group_size = 64;

struct BufferStatisticsPush {
    uint pick, channels; // of a texel: how many, at most 3
    uint tiles;
    uint fitted;         // 1: the range is that of the values
    vec2 range;          // where it is not
};

struct BufferViewPush {
    uint mode, pick;
    vec2 texels;         // of the buffer, along the sides of a pixel
    vec2 origin;         // of the part of the picture that is drawn
};

SHARED_END
#ifdef __cplusplus
static_assert(sizeof(atrium::shared::BufferStatistics) == 24);
#endif
#endif
