// Shadow maps: the faces from which a light sees, and what the passes over them are told.
#ifndef SHARED_SHADOW_H
#define SHARED_SHADOW_H
#include "types.h"
SHARED_BEGIN

const uint shadow_max_faces = 6; // of a light: a cube's, or as many cascades
const uint shadow_cell = 8;      // texels along the side of a cell of the finest level of depth ranges
const uint shadow_group_size = 64;

/// One square view from a light. A world point p (m) has the map coordinate (x, y) / w, -1 to 1 across the tile, x right
/// and y up; w is z for lights with a place and 1 for the sun.
struct ShadowFace {
    vec4 x; // dot(x, (p, 1))
    vec4 y;
    vec4 z;      // distance along the face's axis, m; sun: from the near side of the scene
    float scale; // half the tile's side: tangent of half the angle; sun: m
};

/// Depth is reversed: near / z for lights with a place; sun: 1 - z / reach.
struct ShadowCullPush {
    ShadowFace face;
    uint perspective;
    float range; // m; 0: none
    uint count;  // of draw tasks
    uint first;  // where the face's commands begin
    float extent; // m by which the light may stand elsewhere (sun: the scene's far end)
};

struct ShadowDrawPush {
    ShadowFace face;
    uint perspective;
    float depth_scale; // near or reach, m
};

struct DepthRangePush {
    uint side;  // texels along a tile
    uint faces;
    uint level; // to be written
    uint cells; // along a tile in level 0: a power of two
};

const uint shadow_hard = 0, shadow_pcf = 1, shadow_pcss = 2; // filters
// What can be looked at: the shader of visibility writes the first four.
const uint show_visibility = 0, show_blocker = 1, show_penumbra = 2, show_cascade = 3, show_map = 4;

// Over which pixels visibility may be averaged, as the penumbra is wide in the picture: its own alone, 4 x 2 or 2 x 4 where
// the surface is seen too steeply for more, 4 x 4.
const float blur_none = 0, blur_row = 1, blur_column = 2, blur_full = 3;

// Sets of samples, one behind the other in a table: for the search for blockers; for the filter; for its filter over a
// texel or two, which comparisons of 2 x 2 texels cover soon; for what is averaged over 4 x 4 pixels; and for the search and
// the filter where a penumbra is too narrow in the picture for that.
const uint set_search = 0, set_filter = 1, set_filter_tiny = 2, set_filter_wide = 3, set_search_narrow = 4, set_filter_narrow = 5;
const uint sample_sets = 6;

/// Of shadow.blocker_samples and shadow.samples.
SHARED_FUNCTION uint samples_in_set(uint set, uint blocker_samples, uint samples)
{
    if (set == set_search) return blocker_samples;
    if (set == set_search_narrow) return 3u * blocker_samples;
    if (set == set_filter_narrow) return 5u * samples / 2u;
    uint fewer = set == set_filter_tiny ? samples / 4u : set == set_filter_wide ? 2u * samples / 3u : samples;
    return fewer < 4u ? 4u : fewer;
}

struct VisibilityPush {
    vec3 position;           // m; not of a sun
    float near;              // m: depth is near / z; sun: where it is 1, along its axis
    vec3 right;              // the light's own axes; a point light's are the world's
    float scale;             // ShadowFace::scale where it has a place
    vec3 up;
    float height_per_spread; // see receiver.glsl: near, or 1 / reach of a sun
    vec3 front;              // where the light travels
    float cos_outer;         // spot
    float size;              // radius, m; sun: tangent of its angular radius
    float range;             // m; 0: none
    float half_width;        // rect, m
    float half_height;
    float side;              // texels along a tile
    float radius;            // pcf: of the disc, texels
    uint faces;
    uint first_face;         // in the table of faces
    uint cells;              // DepthRangePush::cells
    float bias_normal;       // texels along the normal
    float bias_slope;        // texels of the receiver's slope
    uint receiver_plane;
    float weight;            // of what is written
    vec3 from_centre;        // m, light space: where the light stands apart from the centre whose reach it has
};

struct ShadowMapPush { // aov shadow_map
    uint perspective;
    float depth_scale;
};

SHARED_END
#ifdef __cplusplus
static_assert(sizeof(atrium::shared::ShadowFace) == 52);
static_assert(sizeof(atrium::shared::VisibilityPush) <= 128);
#endif
#endif
