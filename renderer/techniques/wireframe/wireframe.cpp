#include "renderer/techniques/wireframe/wireframe.hpp"

#include "renderer/techniques/common/draw_scene.hpp"

namespace atrium {

graph::Tex add_wireframe(graph::Graph& g, graph::Tex picture, graph::Tex depth, std::span<const DrawList> draws,
                         const Geometry& geometry)
{
    const auto lines = [](const MaterialClassInfo&) {
        gpu::GraphicsPipelineDesc desc;
        desc.vertex = "techniques/wireframe/wireframe.vert";
        desc.fragment = "techniques/wireframe/wireframe.frag";
        desc.depth_test = gpu::DepthTest::greater_equal;
        desc.blend = gpu::Blend::alpha;
        desc.lines = true;
        return std::optional(desc);
    };
    for (const DrawList& list : draws) {
        graph::PassBuilder pass = g.raster("wireframe");
        pass.writes(picture, graph::Load::keep).depth_test(depth);
        draw_scene(pass, {list, geometry}, lines);
    }
    return picture;
}

} // namespace atrium
