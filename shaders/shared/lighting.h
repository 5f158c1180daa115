#ifndef SHARED_LIGHTING_H
#define SHARED_LIGHTING_H
#include "types.h"
SHARED_BEGIN

const uint term_ambient = 1, term_emission = 2, term_multi_bounce = 4;

struct LightingPush {
    uint first_light; // [first, end_delta) are lights without area, [end_delta, end) rectangles
    uint end_delta;
    uint end_light;
    uint terms;
    float scale;      // 1, or 1 / exposure to undo it
};

SHARED_END
#endif
