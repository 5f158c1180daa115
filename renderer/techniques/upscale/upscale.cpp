#include "renderer/techniques/upscale/upscale.hpp"

#include "shaders/shared/upscale.h"

#include <cmath>

namespace atrium {
namespace {

graph::Tex picture_of(graph::Graph& g, const char* name, uvec2 size)
{
    return g.texture(name, {gpu::Format::rgba8_unorm, size.x, size.y});
}

/// The specialisation constant of resample.frag.
std::uint32_t filter_of(UpscaleMethod method)
{
    switch (method) {
    case UpscaleMethod::catmullrom:
        return shared::resample_catmull_rom;
    case UpscaleMethod::lanczos:
        return shared::resample_lanczos;
    default:
        return shared::resample_bilinear;
    }
}

} // namespace

graph::Tex add_upscale(graph::Graph& g, graph::Tex picture, uvec2 size, UpscaleMethod method)
{
    const uvec2 source_size = g.size(picture);
    if (method == UpscaleMethod::off || source_size == size) return picture;
    const vec2 scale = vec2(source_size) / vec2(size);
    const shared::UpscalePush push{scale, 0.5f * scale - 0.5f};
    const graph::Tex out = picture_of(g, "upscale", size);
    graph::PassBuilder pass = g.raster("upscale");
    pass.reads(picture).writes(out);
    if (method == UpscaleMethod::fsr1)
        pass.fullscreen("techniques/upscale/easu.frag", {}, push);
    else
        pass.fullscreen("techniques/upscale/resample.frag", {filter_of(method)}, push);
    return out;
}

graph::Tex add_sharpening(graph::Graph& g, graph::Tex picture, float stops)
{
    const graph::Tex out = picture_of(g, "upscale.sharpened", g.size(picture));
    g.raster("upscale.sharpen")
        .reads(picture)
        .writes(out)
        .fullscreen("techniques/upscale/rcas.frag", {}, shared::SharpenPush{std::exp2(-stops)});
    return out;
}

} // namespace atrium
