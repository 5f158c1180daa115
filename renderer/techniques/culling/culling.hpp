#pragma once
// Frustum and facing-cone culling of clusters on the GPU, feeding indirect multi-draws. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/scene/scene.hpp"

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
    v("occlusion", s.occlusion, "Leave out clusters hidden behind what was seen in the frame before");
    v("triangles", s.triangles, "Leave out single triangles that face away or cover no pixel's centre", Cpu{true});
}

/// Neighbouring draw commands that share pipeline and cull mode.
struct DrawRange {
    MaterialClass cls = MaterialClass::opaque;
    bool two_sided = false;
    std::uint32_t first = 0, count = 0;
};

/// What a culling pass works on: tasks (record, cluster) in the scene's tables.
struct DrawTasks {
    std::uint32_t count = 0;
    std::span<const DrawRange> ranges;
    const gpu::Buffer* seen = nullptr; ///< a word per task: whether the frame before saw it
    std::uint64_t index_count = 0;     ///< of all tasks
    std::uint32_t subgroup_size = 0;   ///< 0: single triangles cannot be culled, for the device or the scene's size
};

/// The commands of a frame: one VkDrawIndexedIndirectCommand per task, in draw order.
struct DrawList {
    graph::Buf commands;
    std::span<const DrawRange> ranges;
    std::uint32_t count = 0;
    graph::Buf indices; ///< instead of the scene's own, where triangles were culled
};

/// Reads the scene's tables.  Writes one draw command per task; culled ones draw no instance.
/// Source: Haar & Aaltonen 2015, "GPU-Driven Rendering Pipelines"; cone rule: meshoptimizer.
[[nodiscard]] DrawList add_culling(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s);

/// Occlusion culling in two halves: draw what the first returns, then what the second makes of its depth. Together they
/// hold everything that can be seen, whatever the frame before saw.
/// Source: Haar & Aaltonen 2015, as above; the pyramid: Greene et al. 1993, "Hierarchical Z-Buffer Visibility".
class OcclusionCulling {
public:
    OcclusionCulling(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s);
    /// Commands of the clusters that the frame before saw.
    [[nodiscard]] DrawList add_seen(graph::Graph& g) const;
    /// Reads  depth of the first half (D32, reversed).  Commands of what else it does not hide.
    [[nodiscard]] DrawList add_late(graph::Graph& g, graph::Tex depth) const;

private:
    DrawTasks tasks_;
    CullingSettings settings_;
    graph::Buf seen_, indices_;
};

} // namespace atrium
