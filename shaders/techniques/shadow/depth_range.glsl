// Depth ranges of a shadow map: under cells of texels, the nearest and the farthest depth (reversed: x the largest, y the
// smallest). Cells of level 0 are shadow_cell texels wide, those of each further level twice as wide; every face has
// the same number of them, and level after level lies behind the other. Outside the tile there is nothing.
#include "lib/pass.glsl"
#include "shared/shadow.h"

const vec2 nothing_there = vec2(0.0, 1.0);

/// Place of a cell; `cells` along a face in level 0, a power of two.
uint cell_index(uint cells, uint faces, uint level, uint face, uvec2 at)
{
    uint side = cells >> level, before = (cells * cells - side * side) / 3u * 4u; // a geometric series
    return faces * before + (face * side + at.y) * side + at.x;
}
