#ifndef SHARED_PASS_H
#define SHARED_PASS_H
// Where set 2 starts to count what a pass declared, by kind. Read by C++ (renderer/gpu/descriptors.hpp) and GLSL
// (shaders/lib/pass.glsl). Macros, because a layout qualifier takes only what the preprocessor knows.
#define PASS_FIRST_IMAGE 0          // sampled images
#define PASS_FIRST_BUFFER 32        // storage buffers
#define PASS_FIRST_STORAGE_IMAGE 64 // storage images
#define PASS_BINDINGS_PER_KIND 32
#endif
