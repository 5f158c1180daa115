#include "renderer/techniques/tonemap/tonemap.hpp"

#include <cmath>

namespace atrium {

float exposure_scale(const ExposureSettings& s)
{
    return std::exp2(-s.ev100);
}

graph::Tex add_tonemap(graph::Graph& g, graph::Tex hdr, const TonemapSettings& s)
{
    graph::TexDesc desc = g.desc(hdr);
    desc.format = gpu::Format::rgba8_srgb;
    const graph::Tex picture = g.texture("picture", desc);

    g.raster("tonemap").reads(hdr).writes(picture).fullscreen("techniques/tonemap/tonemap.frag",
                                                              {static_cast<std::uint32_t>(s.tone_operator)});
    return picture;
}

} // namespace atrium
