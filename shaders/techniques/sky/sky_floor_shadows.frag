#version 460
// Sky and floor with shadows.
#extension GL_GOOGLE_include_directive : require
#define SHADOWS
#include "techniques/sky/sky_floor.glsl"
