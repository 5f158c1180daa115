// Set 2: what the pass declared. Its n-th sampled image is PASS_IMAGE(n), its n-th storage buffer PASS_BUFFER(n), its
// n-th storage image PASS_STORAGE_IMAGE(n) (renderer/gpu/descriptors.hpp).
#ifndef PASS_GLSL
#define PASS_GLSL
#extension GL_EXT_samplerless_texture_functions : require

#define PASS_IMAGE(n) set = 2, binding = n
#define PASS_BUFFER(n) set = 2, binding = 12 + n
#define PASS_STORAGE_IMAGE(n) set = 2, binding = 19 + n

#endif
