// Set 2: what the pass declared, each kind numbered in order of declaration. Its n-th sampled image is at PASS_IMAGE(n), its
// n-th storage buffer at PASS_BUFFER(n), its n-th storage image at PASS_STORAGE_IMAGE(n). The graph compares the
// declarations with the shaders' bindings when a pipeline is made (renderer/graph/bindings.hpp).
#ifndef PASS_GLSL
#define PASS_GLSL
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/pass.h"

#define PASS_IMAGE(n) set = 2, binding = PASS_FIRST_IMAGE + n
#define PASS_BUFFER(n) set = 2, binding = PASS_FIRST_BUFFER + n
#define PASS_STORAGE_IMAGE(n) set = 2, binding = PASS_FIRST_STORAGE_IMAGE + n

#endif
