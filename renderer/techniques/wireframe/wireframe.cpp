#include "renderer/techniques/wireframe/wireframe.hpp"

namespace atrium {

void add_wireframe(graph::Graph& g, graph::Tex picture, graph::Tex depth, std::span<const DrawList> draws,
                   const Geometry& geometry)
{
    gpu::GraphicsPipelineDesc lines;
    lines.vertex = "techniques/wireframe/wireframe.vert";
    lines.fragment = "techniques/wireframe/wireframe.frag";
    lines.input = gpu::VertexInput::scene;
    lines.depth_test = gpu::DepthTest::greater_equal;
    lines.blend = gpu::Blend::alpha;
    lines.lines = true;
    for (const DrawList& list : draws) {
        graph::PassBuilder pass = g.raster("wireframe");
        reads(pass, list)
            .writes(picture, graph::Load::keep)
            .depth_test(depth)
            .pipeline(lines)
            .record([list, geometry](graph::Cmd& cmd) {
                cmd.bind();
                bind_geometry(cmd, geometry, list);
                for (const DrawRange& range : list.ranges) {
                    cmd.cull(range.two_sided ? graph::CullMode::none : graph::CullMode::back);
                    cmd.draw_indexed_indirect(list.commands, range.first, range.count);
                }
            });
    }
}

} // namespace atrium
