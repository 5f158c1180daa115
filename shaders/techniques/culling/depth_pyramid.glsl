// Asking the depth pyramid, which is storage buffer PYRAMID_BUFFER of the pass.
#include "lib/frame.glsl"
#include "lib/pass.glsl"
#include "shared/culling.h"

layout(PASS_BUFFER(PYRAMID_BUFFER), scalar) readonly buffer Pyramid { float pyramid[]; };

const uint widest = 8; // cells of a level along the side of a rectangle: more cost time, fewer hide less

const uint hides_nothing = 0, hides_part = 1, hides_all = 2;

/// How much of what lies between `low` and `high` (pixels) and between `nearest` and `farthest` (reversed depths) the
/// depth drawn so far hides. With equal depths: hides_nothing or hides_all.
uint occlusion(PyramidLevel levels[pyramid_levels], vec2 low, vec2 high, float nearest, float farthest)
{
    ivec2 last_pixel = ivec2(frame.size) - 1;
    ivec2 from = clamp(ivec2(floor(low)), ivec2(0), last_pixel), to = clamp(ivec2(floor(high)), ivec2(0), last_pixel);
    from >>= int(pyramid_base_log2);
    to >>= int(pyramid_base_log2);
    uint level = 0u;
    while (level + 1u < pyramid_levels && any(greaterThanEqual(to - from, ivec2(widest)))) {
        ++level;
        from >>= int(pyramid_step_log2);
        to >>= int(pyramid_step_log2);
    }
    nearest *= 1.0001; // a little nearer: rasterised depth is rounded
    bool all_hidden = true, none_hidden = true;
    for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
            float depth = pyramid[levels[level].first + uint(y) * levels[level].cells.x + uint(x)];
            all_hidden = all_hidden && depth > nearest;
            none_hidden = none_hidden && depth <= farthest;
        }
        if (!all_hidden && !none_hidden) return hides_part;
    }
    return all_hidden ? hides_all : none_hidden ? hides_nothing : hides_part;
}
