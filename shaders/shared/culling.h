#ifndef SHARED_CULLING_H
#define SHARED_CULLING_H
#include "types.h"
SHARED_BEGIN

const uint cull_frustum = 1, cull_cone = 2, cull_single_triangles = 4;
const uint instances_of_partly_hidden = 2; // in a command that `cull` leaves to `cull.triangles`: some may be hidden
const uint cull_group_size = 64;

// Squared angle per triangle, in square radians, from which a cluster is an occluder: its triangles then take some
// thousand pixels each of a picture 720 high at 60 degrees. Smaller ones hide little for what their depth costs.
const float occluder_angle2 = 1e-3;

/// A cluster of a record: one command of the indirect multi-draw.
struct DrawTask {
    uint record;
    uint cluster;
    uint slot; // first of its indices in a buffer with room for those of every task
};

struct DrawCommand { // VkDrawIndexedIndirectCommand
    uint index_count;
    uint instance_count;
    uint first_index;
    int vertex_offset;
    uint first_instance;
};

struct CullPush {
    uint count;
    uint flags;
};

/// A vertex as the bake holds it; see atrium::Vertex.
struct PackedVertex {
    vec3 position;
    uint normal;
    uint tangent;
    vec2 uv;
};

const uint pyramid_levels = 3;
const uint pyramid_base_log2 = 2, pyramid_base = 1u << pyramid_base_log2; // pixels along the side of a cell of level 0
const uint pyramid_step_log2 = 2, pyramid_step = 1u << pyramid_step_log2; // its cells along the side of one of the next
const uint pyramid_group_size = 64;

/// A level of the depth pyramid: rows of cells, each the smallest (farthest) reversed depth under it.
struct PyramidLevel {
    uvec2 cells;
    uint first; // of its cells in the pyramid's buffer
};

struct PyramidPush {
    PyramidLevel source; // not used for level 0, which reads the depth image
    PyramidLevel target;
};

struct OcclusionPush {
    CullPush cull;
    PyramidLevel levels[pyramid_levels];
};

/// Frames count from 2: in a table filled with zeros no triangle was drawn by the frame before.
const uint first_remembered_frame = 2;
const uint frames_until_asked_again = 4; // whether a triangle that is drawn can still be seen

struct SeenPush {
    OcclusionPush occlusion;
    uint frame;
};

SHARED_END
#ifdef __cplusplus
static_assert(sizeof(atrium::shared::DrawCommand) == 20);
#endif
#endif
