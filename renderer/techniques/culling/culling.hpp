#pragma once
// Frustum and facing-cone culling of clusters on the GPU, feeding indirect multi-draws. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/techniques/common/draw_list.hpp"

#include <span>
#include <vector>

namespace atrium {

struct CullingSettings {
    bool frustum = true;
    bool cone = true;
    bool occlusion = true;
    bool triangles = false;
};

template <class V>
void describe(V& v, CullingSettings& s)
{
    v.group("culling", "Culling");
    v("frustum", s.frustum, "Leave out clusters outside the view");
    v("cone", s.cone, "Leave out clusters of which every triangle faces away (one-sided meshes)");
    v("occlusion", s.occlusion, "Draw depth of large triangles first, and leave out what it hides");
    v("triangles", s.triangles, "Leave out single triangles that face away, cover no pixel's centre or are hidden",
      Cpu{true});
}

/// What a culling pass works on: tasks (record, cluster) in the scene's tables.
struct DrawTasks {
    std::uint32_t count = 0;
    std::span<const DrawRange> ranges;
    std::uint64_t index_count = 0;   ///< of all tasks
    std::uint32_t subgroup_size = 0; ///< 0: single triangles cannot be culled (GpuScene::note() says why)
    std::uint32_t subpixel_bits = 4; ///< of the device's rasterisation
};

/// Visible triangles of this and the previous frame, from declare_seen().
struct SeenInFrame {
    DrawList before, occluders;                      ///< what the frame before saw, and what of it hides much
    graph::Buf commands, occluder_commands, indices; ///< of what this one sees, to be filled
    graph::Buf frames;                               ///< of each triangle, the number of the frame that last saw it
    std::uint32_t frame = 0;                         ///< this one's number
};

/// Reads  the scene's tables; with `occluders`, their depth (D32, reversed).  One draw command per task; culled ones
/// draw no instance. Passes `cull`, with single triangles `cull.triangles`, with occluders `depth_pyramid.N`. Source:
/// Haar & Aaltonen 2015, "GPU-Driven Rendering Pipelines"; cone rule: meshoptimizer; triangles: Wihlidal 2016,
/// "Optimizing the Graphics Pipeline with Compute"; pyramid: Greene et al. 1993, "Hierarchical Z-Buffer Visibility".
[[nodiscard]] DrawList add_culling(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s,
                                   graph::Tex occluders = {});

/// Reads  the scene's tables, depth (D32, reversed) of what the frame before saw.  Fills  `seen`.  What can be seen and
/// was not drawn from seen.before: passes as above, and can_remember() must hold.
[[nodiscard]] DrawList add_culling(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s, graph::Tex depth,
                                   const SeenInFrame& seen);

/// Whether frames can begin with what the one before saw: hidden and single triangles are culled, which the device and
/// the scene must allow.
[[nodiscard]] bool can_remember(const DrawTasks& tasks, const CullingSettings& s);

/// Reads  the scene's tables.  The tasks whose depth is worth drawing before everything else: in the view, without
/// holes, and with triangles large enough to hide much. Pass `cull.occluders`.
[[nodiscard]] DrawList add_occluders(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s);

} // namespace atrium
