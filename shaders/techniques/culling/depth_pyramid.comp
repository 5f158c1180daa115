#version 460
// A further level of the depth pyramid: the farthest depth of pyramid_step x pyramid_step cells of the level below.
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "shared/culling.h"

layout(local_size_x = pyramid_group_size) in;
layout(PASS_BUFFER(0), scalar) buffer Pyramid { float pyramid[]; };
layout(push_constant, scalar) uniform Push { PyramidPush push; };

void main()
{
    uint i = gl_GlobalInvocationID.x; // of the largest image one row of work groups
    if (i >= push.target.cells.x * push.target.cells.y) return;
    uvec2 from = uvec2(i % push.target.cells.x, i / push.target.cells.x) * pyramid_step;
    uvec2 to = min(from + pyramid_step, push.source.cells);
    float farthest = 1e30;
    for (uint y = from.y; y < to.y; ++y) {
        for (uint x = from.x; x < to.x; ++x) {
            farthest = min(farthest, pyramid[push.source.first + y * push.source.cells.x + x]);
        }
    }
    pyramid[push.target.first + i] = farthest;
}
