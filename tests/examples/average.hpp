#pragma once
// The mean of a picture over time: the worked example of "Add a technique with history" in ARCHITECTURE.md.

#include "renderer/graph/graph.hpp"

namespace atrium {

/// Reads  a picture.  Writes  its exponential average over the frames since the last cut or resize. `weight`: of this
/// frame's picture, 0 to 1.
[[nodiscard]] inline graph::Tex add_average(graph::Graph& g, graph::Tex picture, float weight)
{
    graph::TexDesc desc = g.desc(picture);
    desc.format = gpu::Format::rgba32_float;
    const graph::Tex average = g.persistent("average", desc);
    const auto [before, valid] = g.history(average);
    g.raster("average")
        .reads(picture)
        .reads(valid ? before : picture)
        .writes(average)
        .fullscreen("examples/average.frag", {}, valid ? weight : 1.0f);
    return average;
}

} // namespace atrium
