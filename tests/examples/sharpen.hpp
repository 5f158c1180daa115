#pragma once
// Sharpens a picture: the worked example of "Write a storage image" in ARCHITECTURE.md.

#include "renderer/graph/graph.hpp"

namespace atrium {

/// Reads  a picture.  Writes  the picture plus `strength` times its difference from the mean of the four neighbours.
[[nodiscard]] inline graph::Tex add_sharpen(graph::Graph& g, graph::Tex picture, float strength)
{
    graph::TexDesc desc = g.desc(picture);
    desc.format = gpu::Format::rgba32_float;
    const graph::Tex sharp = g.texture("sharp", desc);
    g.compute("sharpen")
        .reads(picture)
        .writes(sharp)
        .pipeline(gpu::ComputePipelineDesc{"examples/sharpen.comp", {}})
        .record([=](graph::Cmd& cmd) {
            cmd.bind();
            cmd.push(strength);
            cmd.dispatch_over(sharp);
        });
    return sharp;
}

} // namespace atrium
