#version 460
// Deferred lighting with ambient occlusion and shadows.
#extension GL_GOOGLE_include_directive : require
#define AMBIENT_OCCLUSION
#define SHADOWS 7
#include "techniques/lighting/lighting.glsl"
