// Ambient occlusion's parameters.
#ifndef SHARED_AO_H
#define SHARED_AO_H
#include "types.h"
SHARED_BEGIN

struct AoPush {
    float radius;  // m
    float falloff; // share of the radius over which what stands there stops counting
    float power;   // of the result; 1: as reckoned
    float thin;    // 0: what is seen goes on for ever behind; more: distances along the view count 1 + thin times
    uint scale;    // full-size pixels along the side of a texel: 1 or 2
    uint blur;     // 1: a blur follows, and the power is for it to take
};

SHARED_END
#endif
