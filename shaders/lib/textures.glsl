// Set 0: the textures of all materials, by slot, and the samplers.
#ifndef TEXTURES_GLSL
#define TEXTURES_GLSL
#extension GL_EXT_nonuniform_qualifier : require

layout(set = 0, binding = 0) uniform texture2D textures[];
layout(set = 0, binding = 1) uniform sampler samplers[5];
layout(set = 0, binding = 1) uniform samplerShadow comparison_samplers[5];

const uint sampler_material = 0, sampler_material_clamp = 1, sampler_linear_clamp = 2, sampler_nearest_clamp = 3, sampler_shadow = 4;

#endif
