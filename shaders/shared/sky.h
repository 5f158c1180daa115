// The floor below a scene.
#ifndef SHARED_SKY_H
#define SHARED_SKY_H
#include "types.h"
SHARED_BEGIN

struct FloorPush {
    vec3 middle;  // of the scene, on the floor, m, world
    float radius; // of the scene, m
};

SHARED_END
#endif
