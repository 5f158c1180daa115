#pragma once
// All smaller sizes of a picture: the worked example of "Make and read mips" in ARCHITECTURE.md.

#include "renderer/graph/graph.hpp"

#include <fmt/format.h>

namespace atrium {

/// Reads  a picture.  Writes  half its size, a quarter of it, … down to one texel, as the mips of one image.
[[nodiscard]] inline graph::Tex add_mip_chain(graph::Graph& g, graph::Tex picture)
{
    const uvec2 half = g.size(picture, 1);
    const graph::Tex chain = g.texture(
        "mips", {.format = gpu::Format::rgba32_float, .width = half.x, .height = half.y, .mips = graph::all_mips});
    for (std::uint32_t mip = 0; mip < g.desc(chain).mips; ++mip) {
        graph::PassBuilder pass = g.raster(fmt::format("mips.{}", mip));
        if (mip == 0)
            pass.reads(picture);
        else
            pass.reads_mip(chain, mip - 1);
        pass.writes_mip(chain, mip).fullscreen("examples/mip_chain.frag");
    }
    return chain;
}

} // namespace atrium
