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

FloorSurface add_floor(graph::Graph& g, graph::Tex depth, const FloorPlace& place)
{
    graph::TexDesc desc = g.desc(depth);
    desc.format = Format::r32_float;
    FloorSurface floor;
    floor.place = place;
    floor.visible_depth = g.texture("sky.floor.depth", desc);
    floor.whole_depth = g.texture("sky.floor.whole_depth", desc);
    desc.format = Format::rg32_uint;
    floor.normal = g.texture("sky.floor.normal", desc);
    g.raster("sky.floor")
        .reads(depth)
        .writes(floor.visible_depth)
        .writes(floor.whole_depth)
        .writes(floor.normal)
        .fullscreen("techniques/sky/floor.frag", {}, push_of(place));
    return floor;
}

namespace {

/// A full-screen pipeline that draws only pixels without geometry.
gpu::GraphicsPipelineDesc behind_everything(const char* fragment)
{
    gpu::GraphicsPipelineDesc desc;
    desc.vertex = "lib/fullscreen.vert";
    desc.fragment = fragment;
    desc.depth_test = gpu::DepthTest::equal_zero;
    return desc;
}

} // namespace

graph::Tex add_sky(graph::Graph& g, graph::Tex depth, graph::Tex radiance)
{
    g.raster("sky")
        .depth_test(depth)
        .writes(radiance, graph::Load::keep)
        .pipeline(behind_everything("techniques/sky/sky.frag"))
        .record([](graph::Cmd& cmd) {
            cmd.bind();
            cmd.draw_fullscreen();
        });
    return radiance;
}

graph::Tex add_sky_and_floor(graph::Graph& g, graph::Tex depth, graph::Tex radiance, const FloorSurface& floor,
                             const FloorLight& light)
{
    gpu::GraphicsPipelineDesc desc = behind_everything("techniques/sky/sky_floor.frag");
    const auto is_one = [&](graph::Tex image) { return g.constant_value(image) == 1.0f; };
    desc.constants = {light.rects ? 1u : 0u, is_one(light.ao) ? 0u : 1u, is_one(light.visibility) ? 0u : 1u};
    g.raster("sky")
        .depth_test(depth)
        .reads(floor.visible_depth)
        .reads(light.ao)
        .reads(light.visibility)
        .writes(radiance, graph::Load::keep)
        .pipeline(desc)
        .record([push = push_of(floor.place)](graph::Cmd& cmd) {
            cmd.bind();
            cmd.push(push);
            cmd.draw_fullscreen();
        });
    return radiance;
}

} // namespace atrium
