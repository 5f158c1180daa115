#version 460
// Sky and floor, without shadows.
#extension GL_GOOGLE_include_directive : require
#include "techniques/sky/sky_floor.glsl"
