#pragma once
// Number of surfaces at the visible depth: the worked example of a pass over the scene in ARCHITECTURE.md.

#include "renderer/techniques/common/draw_scene.hpp"
#include "renderer/techniques/gbuffer/gbuffer.hpp"

namespace atrium {

/// Reads  draw commands, the G-buffer's depth.  Writes  per pixel the number of surfaces that pass the depth test,
/// holes filled (R32F).
[[nodiscard]] inline graph::Tex add_surface_count(graph::Graph& g, const GBuffer& gb, const DrawList& draws,
                                                  const Geometry& geometry)
{
    graph::TexDesc desc = g.desc(gb.depth);
    desc.format = gpu::Format::r32_float;
    const graph::Tex count = g.texture("surface_count", desc);
    graph::PassBuilder pass = g.raster("surface_count");
    pass.writes(count, graph::Load::clear).depth_test(gb.depth);
    draw_scene(pass, {draws, geometry}, [](const MaterialClassInfo&) {
        gpu::GraphicsPipelineDesc pipeline;
        pipeline.vertex = "techniques/gbuffer/depth_prepass.vert";
        pipeline.fragment = "techniques/aov/overdraw.frag"; // adds one
        pipeline.depth_test = gpu::DepthTest::greater_equal;
        pipeline.blend = gpu::Blend::add;
        return std::optional(pipeline); // std::nullopt: the class is not drawn
    });
    return count;
}

} // namespace atrium
