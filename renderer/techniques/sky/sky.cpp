#include "renderer/techniques/sky/sky.hpp"

namespace atrium {

void add_sky(graph::Graph& g, graph::Tex depth, graph::Tex radiance)
{
    gpu::GraphicsPipelineDesc desc;
    desc.vertex = "lib/fullscreen.vert";
    desc.fragment = "techniques/sky/sky.frag";
    desc.depth_test = gpu::DepthTest::equal_zero;
    g.raster("sky").depth_test(depth).writes(radiance, graph::Load::keep).pipeline(desc).record([](graph::Cmd& cmd) {
        cmd.bind();
        cmd.draw_fullscreen();
    });
}

} // namespace atrium
