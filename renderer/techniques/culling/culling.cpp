#include "renderer/techniques/culling/culling.hpp"

#include "shaders/shared/culling.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace atrium {

namespace {

using Levels = std::array<shared::PyramidLevel, shared::pyramid_levels>;

bool culls_triangles(const DrawTasks& tasks, const CullingSettings& s)
{
    return s.triangles && tasks.subgroup_size > 0 && tasks.count > 0;
}

shared::CullPush push_of(const DrawTasks& tasks, const CullingSettings& s)
{
    return {tasks.count, (s.frustum ? shared::cull_frustum : 0u) | (s.cone ? shared::cull_cone : 0u) |
                             (culls_triangles(tasks, s) ? shared::cull_single_triangles : 0u)};
}

graph::Buf create_commands(graph::Graph& g, const char* name, const DrawTasks& tasks)
{
    return g.buffer(name, std::max(tasks.count, 1u) * sizeof(shared::DrawCommand));
}

/// A culling pass whose first buffer is `commands`.
template <class Push>
void dispatch_per_task(graph::PassBuilder& pass, const char* shader, std::uint32_t count, const Push& push)
{
    pass.pipeline(gpu::ComputePipelineDesc{shader, {}}).record([=](graph::Cmd& cmd) {
        cmd.bind();
        cmd.push(push);
        cmd.dispatch(count, shared::cull_group_size);
    });
}

uvec2 cells_over(uvec2 size, std::uint32_t side)
{
    return (size + side - 1u) / side;
}

Levels levels_over(uvec2 size)
{
    Levels levels;
    uvec2 cells = cells_over(size, shared::pyramid_base);
    std::uint32_t first = 0;
    for (shared::PyramidLevel& level : levels) {
        level = {cells, first};
        first += cells.x * cells.y;
        cells = cells_over(cells, shared::pyramid_step);
    }
    return levels;
}

graph::Buf add_depth_pyramid(graph::Graph& g, graph::Tex depth, const Levels& levels)
{
    const shared::PyramidLevel& top = levels.back();
    const graph::Buf pyramid = g.buffer("depth_pyramid", (top.first + top.cells.x * top.cells.y) * sizeof(float));
    for (std::uint32_t i = 0; i < levels.size(); ++i) {
        const shared::PyramidPush push{levels[i > 0 ? i - 1 : 0], levels[i]};
        graph::PassBuilder pass = g.compute(fmt::format("depth_pyramid.{}", i));
        if (i == 0) {
            pass.reads(depth).writes(pyramid);
        } else {
            pass.updates(pyramid);
        }
        pass
            .pipeline(gpu::ComputePipelineDesc{
                i == 0 ? "techniques/culling/depth_pyramid_base.comp" : "techniques/culling/depth_pyramid.comp", {}})
            .record([push](graph::Cmd& cmd) {
                cmd.bind();
                cmd.push(push);
                cmd.dispatch(push.target.cells.x * push.target.cells.y, shared::pyramid_group_size);
            });
    }
    return pyramid;
}

/// Thins out what `list` draws, which becomes a copy of the indices that are kept. Without a pyramid nothing is hidden.
template <class Push>
void add_triangle_culling(graph::Graph& g, const DrawTasks& tasks, DrawList& list, const char* shader,
                          graph::Buf pyramid, const SeenInFrame* seen, const Push& push)
{
    const float snap = std::exp2(-static_cast<float>(tasks.subpixel_bits)) + 1.0f / 512; // and its viewport's rounding
    list.indices = g.buffer("cull.triangles.indices", tasks.index_count * sizeof(std::uint32_t));
    graph::PassBuilder pass = g.compute("cull.triangles");
    pass.updates(list.commands).writes(list.indices);
    if (pyramid) pass.reads(pyramid);
    if (seen) pass.writes(seen->commands).writes(seen->occluder_commands).writes(seen->indices).updates(seen->frames);
    pass.pipeline(gpu::ComputePipelineDesc{shader, {tasks.subgroup_size, std::bit_cast<std::uint32_t>(snap)}})
        .record([count = tasks.count, push](graph::Cmd& cmd) {
            cmd.bind();
            cmd.push(push);
            cmd.dispatch(count, 1);
        });
}

/// Passes `depth_pyramid.N`, where there is `depth`, `cull` and `cull.triangles`.
DrawList add_culling_passes(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s, graph::Tex depth,
                            const SeenInFrame* seen)
{
    DrawList list{create_commands(g, "draw_commands", tasks), tasks.ranges, tasks.count, {}};
    shared::OcclusionPush push{push_of(tasks, s), {}};
    graph::Buf pyramid;
    if (depth) {
        const Levels levels = levels_over({g.desc(depth).width, g.desc(depth).height});
        std::copy(levels.begin(), levels.end(), push.levels);
        pyramid = add_depth_pyramid(g, depth, levels);
    }
    graph::PassBuilder pass = g.compute("cull");
    pass.writes(list.commands);
    if (pyramid) pass.reads(pyramid);
    dispatch_per_task(pass, pyramid ? "techniques/culling/cull_visible.comp" : "techniques/culling/cull.comp",
                      tasks.count, push);
    if (!culls_triangles(tasks, s)) return list;
    if (seen) {
        add_triangle_culling(g, tasks, list, "techniques/culling/cull_triangles_seen.comp", pyramid, seen,
                             shared::SeenPush{push, seen->frame});
    } else {
        add_triangle_culling(g, tasks, list,
                             pyramid ? "techniques/culling/cull_triangles_visible.comp"
                                     : "techniques/culling/cull_triangles.comp",
                             pyramid, nullptr, push);
    }
    return list;
}

} // namespace

bool can_remember(const DrawTasks& tasks, const CullingSettings& s)
{
    return s.occlusion && culls_triangles(tasks, s);
}

DrawList add_occluders(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s)
{
    DrawList list{create_commands(g, "occluder_commands", tasks), tasks.ranges, tasks.count, {}};
    graph::PassBuilder pass = g.compute("cull.occluders");
    pass.writes(list.commands);
    dispatch_per_task(pass, "techniques/culling/cull_occluders.comp", tasks.count, push_of(tasks, s));
    return list;
}

DrawList add_culling(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s, graph::Tex occluders)
{
    return add_culling_passes(g, tasks, s, occluders, nullptr);
}

DrawList add_culling(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s, graph::Tex depth,
                     const SeenInFrame& seen)
{
    return add_culling_passes(g, tasks, s, depth, &seen);
}

} // namespace atrium
