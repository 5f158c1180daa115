// Depth and normals of the visible surfaces: the first two images that a pass declares, in this order. They come from a
// G-buffer or from a prepass that writes depth and normals.
#ifndef DEPTH_NORMAL_GLSL
#define DEPTH_NORMAL_GLSL
#include "lib/octahedral.glsl"
#include "lib/pass.glsl"

layout(PASS_IMAGE(0)) uniform texture2D depth_image;   // reversed, infinite
layout(PASS_IMAGE(1)) uniform utexture2D normal_image; // as the G-buffer packs it

float fetch_depth(ivec2 pixel) { return texelFetch(depth_image, pixel, 0).x; }

/// Normal of the triangle, without normal map: unit, world, towards the camera.
vec3 fetch_geometric_normal(ivec2 pixel) { return oct_unpack(texelFetch(normal_image, pixel, 0).y, 12u); }

#endif
