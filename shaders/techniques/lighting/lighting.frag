#version 460
// Deferred lighting without ambient occlusion.
#extension GL_GOOGLE_include_directive : require
#include "techniques/lighting/lighting.glsl"
