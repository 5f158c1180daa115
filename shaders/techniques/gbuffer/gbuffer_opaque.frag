#version 460
#extension GL_GOOGLE_include_directive : require
#include "materials/opaque.glsl"
#include "techniques/gbuffer/gbuffer.glsl"

layout(early_fragment_tests) in;
