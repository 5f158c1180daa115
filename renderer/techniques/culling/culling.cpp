#include "renderer/techniques/culling/culling.hpp"

#include "shaders/shared/culling.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace atrium {
namespace {

using Levels = std::array<shared::PyramidLevel, shared::pyramid_levels>;

shared::CullPush push_of(const DrawTasks& tasks, const CullingSettings& s)
{
    return {tasks.count, (s.frustum ? shared::cull_frustum : 0u) | (s.cone ? shared::cull_cone : 0u)};
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
        pass.pipeline(gpu::ComputePipelineDesc{i == 0 ? "techniques/culling/depth_pyramid_base.comp"
                                                      : "techniques/culling/depth_pyramid.comp",
                                               {}})
            .record([push](graph::Cmd& cmd) {
                cmd.bind();
                cmd.push(push);
                cmd.dispatch(push.target.cells.x * push.target.cells.y, shared::pyramid_group_size);
            });
    }
    return pyramid;
}

bool culls_triangles(const DrawTasks& tasks, const CullingSettings& s)
{
    return s.triangles && tasks.subgroup_size > 0 && tasks.count > 0;
}

graph::Buf create_indices(graph::Graph& g, const DrawTasks& tasks)
{
    return g.buffer("culled_indices", tasks.index_count * sizeof(std::uint32_t));
}

/// Thins out what `list` draws. `indices` has a slot for each task, so lists without common tasks can share it.
void add_triangle_culling(graph::Graph& g, const DrawTasks& tasks, DrawList& list, graph::Buf indices,
                          const std::string& pass_name)
{
    list.indices = indices;
    g.compute(pass_name)
        .updates(list.commands)
        .updates(indices)
        .pipeline(gpu::ComputePipelineDesc{"techniques/culling/cull_triangles.comp", {tasks.subgroup_size}})
        .record([count = tasks.count](graph::Cmd& cmd) {
            cmd.bind();
            cmd.dispatch(count, 1);
        });
}

} // namespace

DrawList add_culling(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s)
{
    const graph::Buf commands = create_commands(g, "draw_commands", tasks);
    graph::PassBuilder pass = g.compute("cull");
    pass.writes(commands);
    dispatch_per_task(pass, "techniques/culling/cull.comp", tasks.count, push_of(tasks, s));
    DrawList list{commands, tasks.ranges, tasks.count, {}};
    if (culls_triangles(tasks, s)) add_triangle_culling(g, tasks, list, create_indices(g, tasks), "cull.triangles");
    return list;
}

OcclusionCulling::OcclusionCulling(graph::Graph& g, const DrawTasks& tasks, const CullingSettings& s)
    : tasks_(tasks), settings_(s), seen_(g.import("seen", *tasks.seen, gpu::Access::storage_write))
{
    if (culls_triangles(tasks, s)) indices_ = create_indices(g, tasks);
}

DrawList OcclusionCulling::add_seen(graph::Graph& g) const
{
    const graph::Buf commands = create_commands(g, "draw_commands", tasks_);
    graph::PassBuilder pass = g.compute("cull");
    pass.writes(commands).reads(seen_);
    dispatch_per_task(pass, "techniques/culling/cull_seen.comp", tasks_.count, push_of(tasks_, settings_));
    DrawList list{commands, tasks_.ranges, tasks_.count, {}};
    if (indices_) add_triangle_culling(g, tasks_, list, indices_, "cull.triangles");
    return list;
}

DrawList OcclusionCulling::add_late(graph::Graph& g, graph::Tex depth) const
{
    const Levels levels = levels_over({g.desc(depth).width, g.desc(depth).height});
    const graph::Buf pyramid = add_depth_pyramid(g, depth, levels);
    const graph::Buf commands = create_commands(g, "draw_commands.late", tasks_);
    shared::LateCullPush push{push_of(tasks_, settings_), {}};
    std::copy(levels.begin(), levels.end(), push.levels);

    graph::PassBuilder pass = g.compute("cull.late");
    pass.writes(commands).updates(seen_).reads(pyramid);
    dispatch_per_task(pass, "techniques/culling/cull_late.comp", tasks_.count, push);
    g.keep(seen_, gpu::Access::storage_write);
    DrawList list{commands, tasks_.ranges, tasks_.count, {}};
    if (indices_) add_triangle_culling(g, tasks_, list, indices_, "cull.late.triangles");
    return list;
}

} // namespace atrium
