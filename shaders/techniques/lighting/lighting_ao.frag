#version 460
// Deferred lighting with ambient occlusion.
#extension GL_GOOGLE_include_directive : require
#define AMBIENT_OCCLUSION
#include "techniques/lighting/lighting.glsl"
