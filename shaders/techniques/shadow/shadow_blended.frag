#version 460
#extension GL_GOOGLE_include_directive : require
#include "materials/blended.glsl"
#include "techniques/shadow/shadow_holes.glsl"
