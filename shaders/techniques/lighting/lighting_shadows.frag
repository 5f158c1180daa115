#version 460
// Deferred lighting with shadows.
#extension GL_GOOGLE_include_directive : require
#define SHADOWS 6
#include "techniques/lighting/lighting.glsl"
