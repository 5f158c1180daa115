#include "renderer/techniques/shadow/shadow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

using gpu::Format;

constexpr float least_size = 1e-5f; ///< of a light for the filter, m or tangent: it divides by it

shared::VisibilityPush push_of(const ShadowMap& map, const Light& light, const ShadowSettings& s)
{
    const LightAxes axes = axes_of(light);
    shared::VisibilityPush p{};
    p.position = light.position;
    p.near = map.near;
    p.scale = map.scale;
    p.height_per_spread = map.perspective ? map.depth_scale : 1 / map.depth_scale;
    p.right = axes.right;
    p.up = axes.up;
    p.front = axes.direction;
    p.size = s.softness * light.size;
    p.range = light.range;
    switch (light.type) {
    case LightType::sun:
        p.size = s.softness * std::tan(glm::radians(0.5f * light.angle));
        p.range = 0;
        break;
    case LightType::spot:
        p.cos_outer = std::cos(glm::radians(light.outer));
        break;
    case LightType::point: // a cube's own axes
        p.right = {1, 0, 0};
        p.up = {0, 1, 0};
        p.front = {0, 0, -1};
        break;
    case LightType::rect:
        p.half_width = 0.5f * s.softness * light.width;
        p.half_height = 0.5f * s.softness * light.height;
        p.range = 0;
        break;
    }
    p.size = std::max(p.size, least_size);
    p.half_width = std::max(p.half_width, least_size);
    p.half_height = std::max(p.half_height, least_size);
    p.side = static_cast<float>(map.side);
    p.faces = map.face_count;
    p.first_face = map.first_face;
    p.cells = map.cells;
    p.radius = s.radius;
    p.bias_normal = s.bias_normal;
    p.bias_slope = s.bias_slope;
    p.receiver_plane = s.bias_plane ? 1 : 0;
    return p;
}

std::uint32_t shader_filter(ShadowFilter filter)
{
    switch (filter) {
    case ShadowFilter::pcf:
        return shared::shadow_pcf;
    case ShadowFilter::pcss:
        return shared::shadow_pcss;
    default:
        return shared::shadow_hard;
    }
}

} // namespace

std::size_t most_shadowed_lights(const ShadowSettings& s)
{
    return s.filter == ShadowFilter::off ? 0 : static_cast<std::size_t>(s.max_lights);
}

void add_visibility(graph::Graph& g, graph::Tex depth, graph::Tex normal, const ShadowMapSet& set, const ShadowMap& map,
                    const Light& light, const ShadowSettings& s, ShadowShown shown, const VisibilityTarget& target)
{
    gpu::GraphicsPipelineDesc state;
    state.vertex = "lib/fullscreen.vert";
    state.fragment = "techniques/shadow/visibility.frag";
    state.blend = target.load == graph::Load::discard ? gpu::Blend::off : gpu::Blend::add;
    state.constants = {static_cast<std::uint32_t>(light.type),
                       shader_filter(s.filter),
                       static_cast<std::uint32_t>(s.blocker_samples),
                       static_cast<std::uint32_t>(s.samples),
                       shown,
                       static_cast<std::uint32_t>(target.blurred),
                       static_cast<std::uint32_t>(target.beyond_scene)};
    shared::VisibilityPush push = push_of(map, light, s);
    push.weight = target.weight;
    const vec3 apart = light.position - target.centre.value_or(light.position);
    push.from_centre = {glm::dot(apart, push.right), glm::dot(apart, push.up), glm::dot(apart, push.front)};
    graph::PassBuilder pass = g.raster(target.pass);
    pass.reads(depth)
        .reads(normal)
        .reads(map.map)
        .reads(set.faces)
        .reads(light.type == LightType::rect ? set.square_samples : set.disc_samples)
        .reads(map.ranges)
        .writes_layer(target.image, target.layer, target.load)
        .pipeline(state)
        .record([push](graph::Cmd& cmd) {
            cmd.bind();
            cmd.push(push);
            cmd.draw_fullscreen();
        });
}

graph::Tex create_visibility(graph::Graph& g, graph::Tex depth, std::size_t lights, const std::string& name)
{
    graph::TexDesc desc = g.desc(depth);
    desc.format = Format::r32_float;
    desc.layers = static_cast<std::uint32_t>(lights);
    desc.array = true;
    return g.texture(name, desc);
}

graph::Tex add_all_visibility(graph::Graph& g, graph::Tex depth, graph::Tex normal, const ShadowMapSet& set,
                              std::span<const Light> lights, const ShadowSettings& s, const ShadowReceivers& receivers)
{
    if (set.maps.empty()) return g.constant_array(1);
    const std::string name = receivers.prefix + "visibility";
    const graph::Tex visibility = create_visibility(g, depth, set.maps.size(), name);
    graph::TexDesc one_layer = g.desc(visibility);
    one_layer.layers = 1;
    one_layer.array = false;
    const bool blurred = s.filter == ShadowFilter::pcss && s.blur;
    for (std::uint32_t i = 0; i < set.maps.size(); ++i) {
        const ShadowMap& map = set.maps[i];
        VisibilityTarget target{fmt::format("{}.{}", name, map.light), visibility, i};
        target.beyond_scene = receivers.beyond_scene;
        if (blurred) {
            target.image = g.texture(target.pass + ".raw", one_layer);
            target.layer = 0;
            target.blurred = true;
        }
        add_visibility(g, depth, normal, set, map, lights[map.light], s, shared::show_visibility, target);
        if (blurred) {
            g.raster(target.pass + ".blur")
                .reads(target.image)
                .reads(depth)
                .reads(normal)
                .writes_layer(visibility, i)
                .fullscreen("techniques/shadow/visibility_blur.frag");
        }
    }
    return visibility;
}

namespace {

graph::Tex add_visibility_layer(graph::Graph& g, graph::Tex visibility, std::uint32_t layer, const std::string& pass)
{
    graph::TexDesc desc = g.desc(visibility);
    desc.layers = 1;
    desc.array = false;
    const graph::Tex target = g.texture(pass, desc);
    g.raster(pass).reads(visibility).writes(target).fullscreen("techniques/shadow/visibility_layer.frag", {}, layer);
    return target;
}

graph::Tex add_map_distances(graph::Graph& g, const ShadowMap& map, const std::string& pass)
{
    graph::TexDesc desc = g.desc(map.map);
    desc.format = Format::r32_float;
    const graph::Tex target = g.texture(pass, desc);
    g.raster(pass).reads(map.map).writes(target).fullscreen(
        "techniques/shadow/shadow_map.frag", {}, shared::ShadowMapPush{map.perspective ? 1u : 0u, map.depth_scale});
    return target;
}

} // namespace

graph::Tex add_shadow_image(graph::Graph& g, graph::Tex depth, graph::Tex normal, const ShadowMapSet& set,
                            std::span<const Light> lights, graph::Tex visibility, const ShadowSettings& s,
                            std::uint32_t light, ShadowShown shown, const std::string& pass)
{
    const auto map =
        std::find_if(set.maps.begin(), set.maps.end(), [&](const ShadowMap& m) { return m.light == light; });
    if (map == set.maps.end()) return {};
    if (shown == shared::show_map) return add_map_distances(g, *map, pass);
    const auto layer = static_cast<std::uint32_t>(map - set.maps.begin());
    if (shown == shared::show_visibility) return add_visibility_layer(g, visibility, layer, pass);
    graph::TexDesc desc = g.desc(depth);
    desc.format = Format::r32_float;
    const graph::Tex target = g.texture(pass, desc);
    add_visibility(g, depth, normal, set, *map, lights[light], s, shown, {pass, target});
    return target;
}

} // namespace atrium
