#include "renderer/techniques/sky/sky.hpp"

#include "shaders/shared/sky.h"

#include <algorithm>

namespace atrium {
namespace {

using gpu::Format;

shared::FloorPush push_of(const FloorPlace& place)
{
    return {place.middle, place.radius};
}

} // namespace

FloorPlace floor_below(const Bounds& scene)
{
    FloorPlace place;
    place.middle = scene.centre();
    place.middle.y = scene.min.y;
    place.radius = std::max(0.5f * scene.diagonal(), 1e-6f);
    return place;
}

FloorSurface add_floor(graph::Graph& g, const GBuffer& gb, const FloorPlace& place)
{
    graph::TexDesc desc = g.desc(gb.depth);
    desc.format = Format::r32_float;
    FloorSurface floor{place, gb, gb};
    floor.visible.depth = g.texture("sky.floor.depth", desc);
    floor.whole.depth = g.texture("sky.floor.whole_depth", desc);
    floor.visible.normal = floor.whole.normal = g.texture("sky.floor.normal", g.desc(gb.normal));
    g.raster("sky.floor")
        .reads(gb.depth)
        .writes(floor.visible.depth)
        .writes(floor.whole.depth)
        .writes(floor.visible.normal)
        .fullscreen("techniques/sky/floor.frag", {}, push_of(place));
    return floor;
}

void add_sky(graph::Graph& g, graph::Tex depth, graph::Tex radiance, const FloorSurface& floor, const FloorLight& light)
{
    gpu::GraphicsPipelineDesc desc;
    desc.vertex = "lib/fullscreen.vert";
    desc.fragment = "techniques/sky/sky.frag";
    desc.depth_test = gpu::DepthTest::equal_zero;
    graph::PassBuilder pass = g.raster("sky");
    pass.depth_test(depth).writes(radiance, graph::Load::keep);
    if (!floor) {
        pass.pipeline(desc).record([](graph::Cmd& cmd) {
            cmd.bind();
            cmd.draw_fullscreen();
        });
        return;
    }
    desc.fragment = light.visibility ? "techniques/sky/sky_floor_shadows.frag" : "techniques/sky/sky_floor.frag";
    desc.constants = {light.rects ? 1u : 0u, light.ao ? 1u : 0u};
    pass.reads(floor.visible.depth).reads(light.ao ? light.ao : floor.visible.depth);
    if (light.visibility) pass.reads(light.visibility);
    pass.pipeline(desc).record([push = push_of(floor.place)](graph::Cmd& cmd) {
        cmd.bind();
        cmd.push(push);
        cmd.draw_fullscreen();
    });
}

} // namespace atrium
