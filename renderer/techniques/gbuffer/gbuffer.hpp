#pragma once
// The G-buffer: what the camera sees, unlit. Layout and bits per target: README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/techniques/common/draw_list.hpp"
#include "renderer/techniques/culling/culling.hpp"
#include "renderer/techniques/culling/seen_triangles.hpp"

#include <vector>

namespace atrium {

/// How materials are read.
struct MaterialSettings {
    bool normal_mapping = true;
    bool specular_mapping = true;
};

template <class V>
void describe(V& v, MaterialSettings& s)
{
    v.group("", "Materials");
    v("normal_mapping", s.normal_mapping, "Bend normals by the materials' normal maps", Keys{"N"});
    v("specular_mapping", s.specular_mapping, "Vary specular strength, roughness and metalness by the materials' maps");
}

struct GBuffer {
    graph::Tex albedo, normal, id, emission, motion, depth;
};

/// Declares that a pass samples surfaces: all of the G-buffer but motion, as the pass's first five images, in the order
/// of shaders/lib/gbuffer.glsl. A pass that needs only depth and normals reads those two
/// (shaders/lib/depth_normal.glsl).
graph::PassBuilder& reads(graph::PassBuilder& pass, const GBuffer& gb);

/// Reads  draw commands.  Writes  albedo, normal, id, emission, motion, depth (size x size).
[[nodiscard]] GBuffer add_gbuffer(graph::Graph& g, const DrawList& draws, const Geometry& geometry, uvec2 size,
                                  const std::string& pass_name = "gbuffer");

/// Reads  draw commands.  Writes  depth of their materials without holes, cleared before.
void add_depth_prepass(graph::Graph& g, const DrawList& draws, const Geometry& geometry, graph::Tex depth,
                       const std::string& pass_name = "depth_prepass");

/// A G-buffer, what was drawn into it one after the other, and of what the depth was drawn before (without commands: of
/// nothing).
struct CulledGBuffer {
    GBuffer gbuffer;
    std::vector<DrawList> draws;
    DrawList occluders;
};

/// Culls and draws: passes `cull` and `gbuffer`; with occlusion culling before them `cull.occluders`, `depth_prepass`
/// and `depth_pyramid.N`; with single triangles `cull.triangles`. With `remember`, if occlusion and single triangles
/// are culled: `gbuffer` draws the previous frame's visible triangles, then the passes above cull, and `gbuffer.late`
/// draws the rest.
[[nodiscard]] CulledGBuffer add_culled_gbuffer(graph::Graph& g, const DrawTasks& tasks, const Geometry& geometry,
                                               uvec2 size, const CullingSettings& s, bool remember = false);

} // namespace atrium
