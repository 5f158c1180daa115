#version 460
// Level 0 of the depth pyramid: the farthest depth under cells of pyramid_base x pyramid_base pixels.
#extension GL_GOOGLE_include_directive : require
#include "lib/dispatch.glsl"
#include "lib/frame.glsl"
#include "lib/pass.glsl"
#include "lib/textures.glsl"
#include "shared/culling.h"

layout(local_size_x = pyramid_group_size) in;
layout(PASS_IMAGE(0)) uniform texture2D depth_image;
layout(PASS_BUFFER(0), scalar) writeonly buffer Pyramid { float pyramid[]; };
layout(push_constant, scalar) uniform Push { PyramidPush push; };

void main()
{
    uint i = INVOCATION_INDEX;
    if (i >= push.target.cells.x * push.target.cells.y) return;
    vec2 corner = vec2(i % push.target.cells.x, i / push.target.cells.x) * float(pyramid_base);
    vec4 farthest = vec4(1e30);
    for (uint k = 0u; k < pyramid_base * pyramid_base / 4u; ++k) { // four pixels at a time; the border is repeated
        vec2 pixel = corner + 2.0 * vec2(k % (pyramid_base / 2u), k / (pyramid_base / 2u)) + 1.0;
        farthest = min(farthest, textureGather(sampler2D(depth_image, samplers[sampler_nearest_clamp]), pixel * frame.inv_size));
    }
    pyramid[push.target.first + i] = min(min(farthest.x, farthest.y), min(farthest.z, farthest.w));
}
