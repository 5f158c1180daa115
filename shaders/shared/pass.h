#ifndef SHARED_PASS_H
#define SHARED_PASS_H
// First binding of each kind of descriptor in set 2. Read by C++ (renderer/gpu/descriptors.hpp) and GLSL
// (shaders/lib/pass.glsl). Macros, because the macros of pass.glsl use them in layout qualifiers.
#define PASS_FIRST_IMAGE 0          // sampled images
#define PASS_FIRST_BUFFER 32        // storage buffers
#define PASS_FIRST_STORAGE_IMAGE 64 // storage images
#define PASS_BINDINGS_PER_KIND 32
#endif
