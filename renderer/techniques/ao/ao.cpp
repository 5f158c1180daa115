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

AmbientOcclusion add_ao(graph::Graph& g, graph::Tex depth, graph::Tex normal, const View& view, const AoSettings& s,
                        const std::string& prefix)
{
    if (s.method == AoMethod::off) return {g.constant(1), g.constant(1)};
    const std::uint32_t scale = s.half_resolution ? 2 : 1;
    const shared::AoPush push{s.radius, s.falloff, s.power, s.thin, scale, s.blur ? 1u : 0u};
    const uvec2 full = view.render_size, size = (full + scale - 1u) / scale;
    const graph::TexDesc reduced{Format::rg32_float, size.x, size.y};

    AmbientOcclusion out;
    out.raw = g.texture(prefix + "ao.raw", reduced);
    graph::PassBuilder pass = g.raster(prefix + "ao");
    pass.reads(depth).reads(normal).writes(out.raw);
    if (s.method == AoMethod::gtao)
        pass.fullscreen("techniques/ao/gtao.frag", slices_and_steps(s.samples), push);
    else
        pass.fullscreen("techniques/ao/ssao.frag", {static_cast<std::uint32_t>(s.samples)}, push);

    out.result = out.raw;
    if (s.blur) {
        out.result = g.texture(prefix + "ao.blurred", reduced);
        g.raster(prefix + "ao.blur")
            .reads(depth)
            .reads(normal)
            .reads(out.raw)
            .writes(out.result)
            .fullscreen("techniques/ao/ao_blur.frag", {}, push);
    }
    if (s.half_resolution) {
        const graph::Tex halves = out.result;
        out.result = g.texture(prefix + "ao", {Format::r32_float, full.x, full.y});
        g.raster(prefix + "ao.upsample")
            .reads(depth)
            .reads(normal)
            .reads(halves)
            .writes(out.result)
            .fullscreen("techniques/ao/ao_upsample.frag", {}, push);
    }
    return out;
}

} // namespace atrium
