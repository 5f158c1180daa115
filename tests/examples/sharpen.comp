#version 460
// Moves each pixel away from the mean of its four neighbours.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Push { float strength; };
layout(PASS_IMAGE(0)) uniform texture2D picture;
layout(PASS_STORAGE_IMAGE(0), rgba32f) uniform writeonly image2D sharp;

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), last = textureSize(picture, 0) - 1;
    if (any(greaterThan(pixel, last))) return;
    vec4 around = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i % 2, 1 - i % 2) * (i < 2 ? 1 : -1);
        around += 0.25 * texelFetch(picture, clamp(pixel + offset, ivec2(0), last), 0);
    }
    vec4 own = texelFetch(picture, pixel, 0);
    imageStore(sharp, pixel, own + strength * (own - around));
}
