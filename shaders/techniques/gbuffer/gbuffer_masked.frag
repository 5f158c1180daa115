#version 460
#extension GL_GOOGLE_include_directive : require
#include "materials/masked.glsl"
#include "techniques/gbuffer/gbuffer.glsl"
