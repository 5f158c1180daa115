#include "renderer/techniques/ao/ao.hpp"

#include "shaders/shared/ao.h"

#include <algorithm>

namespace atrium {
namespace {

using gpu::Format;

/// Slices and steps on each side of them. Few slices are noisy, which a blur mends; few steps miss things, which none
/// does: the first nine go to one slice.
std::vector<std::uint32_t> slices_and_steps(int samples)
{
    const int pairs = std::max(samples / 2, 1), slices = std::max(pairs / 9, 1);
    return {static_cast<std::uint32_t>(slices), static_cast<std::uint32_t>(pairs / slices)};
}

} // namespace

AmbientOcclusion add_ao(graph::Graph& g, const GBuffer& gb, const AoSettings& s, const std::string& prefix)
{
    if (s.method == AoMethod::off) return {};
    const std::uint32_t scale = s.half_resolution ? 2 : 1;
    const shared::AoPush push{s.radius, s.falloff, s.power, s.thin, scale, s.blur ? 1u : 0u};
    const graph::TexDesc full = g.desc(gb.depth);
    const graph::TexDesc reckoned{Format::rg32_float, (full.width + scale - 1) / scale,
                                  (full.height + scale - 1) / scale};

    AmbientOcclusion out;
    out.raw = g.texture(prefix + "ao.raw", reckoned);
    graph::PassBuilder pass = g.raster(prefix + "ao");
    reads(pass, gb).writes(out.raw);
    if (s.method == AoMethod::gtao)
        pass.fullscreen("techniques/ao/gtao.frag", slices_and_steps(s.samples), push);
    else
        pass.fullscreen("techniques/ao/ssao.frag", {static_cast<std::uint32_t>(s.samples)}, push);

    out.result = out.raw;
    if (s.blur) {
        out.result = g.texture(prefix + "ao.blurred", reckoned);
        graph::PassBuilder blur = g.raster(prefix + "ao.blur");
        reads(blur, gb).reads(out.raw).writes(out.result).fullscreen("techniques/ao/ao_blur.frag", {}, push);
    }
    if (s.half_resolution) {
        const graph::Tex halves = out.result;
        out.result = g.texture(prefix + "ao", {Format::r32_float, full.width, full.height});
        graph::PassBuilder upsample = g.raster(prefix + "ao.upsample");
        reads(upsample, gb).reads(halves).writes(out.result).fullscreen("techniques/ao/ao_upsample.frag", {}, push);
    }
    return out;
}

} // namespace atrium
