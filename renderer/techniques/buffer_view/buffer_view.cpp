#include "renderer/techniques/buffer_view/buffer_view.hpp"

#include "shaders/shared/buffer_view.h"

#include <algorithm>

namespace atrium {
namespace {

std::uint32_t picked(const BufferLook& look, const BufferViewSettings& s)
{
    switch (s.channels) {
    case BufferChannels::r:
        return shared::pick_r;
    case BufferChannels::g:
        return shared::pick_g;
    case BufferChannels::b:
        return shared::pick_b;
    case BufferChannels::a:
        return look.channels == 4 ? shared::pick_a : shared::pick_none;
    case BufferChannels::all:
        break;
    }
    if (look.channels == 1) return shared::pick_r;
    return s.colors == BufferColors::usual ? shared::pick_all : shared::pick_length;
}

std::uint32_t mode_of(const BufferLook& look, const BufferViewSettings& s)
{
    if (s.colors == BufferColors::viridis) return shared::view_viridis;
    if (s.colors == BufferColors::grey) return shared::view_scalar;
    const bool part = s.channels != BufferChannels::all && look.channels > 1;
    return part ? shared::view_scalar : look.mode;
}

} // namespace

ChosenView choose_view(const BufferLook& look, const BufferViewSettings& s)
{
    ChosenView out{mode_of(look, s), picked(look, s), s.range};
    const bool index_as_number = look.mode == shared::view_index && out.mode != look.mode;
    const bool has_no_usual = index_as_number || out.pick == shared::pick_length || look.low == look.high;
    if (s.range == BufferRange::usual && has_no_usual) out.range = BufferRange::fitted;
    return out;
}

graph::Buf add_buffer_statistics(graph::Graph& g, graph::Tex buffer, const BufferLook& look,
                                 const BufferViewSettings& s, const std::string& name)
{
    const graph::TexDesc& desc = g.desc(buffer);
    const auto tiles_along = [](std::uint32_t texels) {
        return (texels + shared::statistics_tile - 1) / shared::statistics_tile;
    };
    const std::uint32_t count = tiles_along(desc.width) * tiles_along(desc.height);
    const ChosenView view = choose_view(look, s);
    const shared::BufferStatisticsPush push{view.pick, static_cast<std::uint32_t>(std::min(look.channels, 3)), count,
                                            view.range == BufferRange::fitted ? 1u : 0u,
                                            view.range == BufferRange::given ? vec2(s.low, s.high)
                                                                             : vec2(look.low, look.high)};
    const graph::Buf tiles = g.buffer(name + ".tiles", count * sizeof(shared::BufferStatistics));
    const graph::Buf total = g.buffer(name + ".total", sizeof(shared::BufferStatistics));
    const auto record = [push](std::uint32_t threads) {
        return [push, threads](graph::Cmd& cmd) {
            cmd.bind();
            cmd.push(push);
            cmd.dispatch(threads, shared::statistics_group_size);
        };
    };
    g.compute(name + ".tiles")
        .reads(buffer)
        .writes(tiles)
        .pipeline(gpu::ComputePipelineDesc{"techniques/buffer_view/statistics_tiles.comp", {}})
        .record(record(count));
    g.compute(name + ".total")
        .reads(tiles)
        .writes(total)
        .pipeline(gpu::ComputePipelineDesc{"techniques/buffer_view/statistics_total.comp", {}})
        .record(record(1));
    return total;
}

graph::Tex add_buffer_view(graph::Graph& g, graph::Tex buffer, graph::Buf statistics, const BufferLook& look,
                           const BufferViewSettings& s, graph::Tex picture, const PictureArea& area, graph::Load load,
                           const std::string& name)
{
    const vec2 texels = vec2(g.desc(buffer).width, g.desc(buffer).height) / vec2(area.size);
    const ChosenView view = choose_view(look, s);
    const shared::BufferViewPush push{view.mode, view.pick, texels, vec2(area.origin)};
    gpu::GraphicsPipelineDesc pipeline;
    pipeline.vertex = "lib/fullscreen.vert";
    pipeline.fragment = "techniques/buffer_view/buffer_view.frag";
    g.raster(name)
        .reads(buffer)
        .reads(statistics)
        .writes(picture, load)
        .pipeline(pipeline)
        .record([push, area](graph::Cmd& cmd) {
            cmd.bind();
            cmd.viewport(area.origin, area.size);
            cmd.push(push);
            cmd.draw_fullscreen();
        });
    return picture;
}

} // namespace atrium
