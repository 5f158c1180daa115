#include "renderer/techniques/shadow/shadow_maps.hpp"

#include "renderer/core/log.hpp"
#include "renderer/techniques/common/draw_scene.hpp"
#include "renderer/techniques/shadow/light_points.hpp"
#include "renderer/techniques/shadow/sample_sets.hpp"
#include "shaders/shared/culling.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>

namespace atrium {
namespace {

using gpu::Access;

constexpr std::uint64_t sample_seed = 213; // the filter's, the next, is among the most even of 300 at 8 to 64 samples
constexpr std::uint32_t reference_passes = 3600; ///< of all that a frame may have

std::uint32_t cells_along(std::uint32_t side)
{
    return std::bit_ceil((side + shared::shadow_cell - 1) / shared::shadow_cell);
}

std::uint32_t face_count(const Light& light, const ShadowSettings& s)
{
    switch (light.type) {
    case LightType::sun:
        return static_cast<std::uint32_t>(s.cascades);
    case LightType::spot:
        return 1;
    case LightType::point:
        return 6;
    case LightType::rect:
        return 5;
    }
    return 1;
}

/// Radius for which a filter looks around, m.
float extent_of(const Light& light, const ShadowSettings& s)
{
    return s.filter == ShadowFilter::pcss ? light_extent(light, s.softness) : 0;
}

/// The resolution asked for, halved until all maps fit into the budget and each into an image.
std::uint32_t affordable_side(std::span<const Light> lights, std::span<const std::uint32_t> shadowed,
                              const ShadowSettings& s, std::uint32_t widest_image)
{
    std::uint64_t faces = 0;
    std::uint32_t most = 1;
    for (const std::uint32_t i : shadowed) {
        const std::uint32_t own = face_count(lights[i], s);
        faces += own;
        most = std::max(most, own);
    }
    auto side = static_cast<std::uint32_t>(s.resolution);
    const std::uint64_t budget = static_cast<std::uint64_t>(s.budget) << 20;
    while (side > 64 && (faces * side * side * sizeof(float) > budget || most * side > widest_image)) side /= 2;
    return side;
}

/// What a user should know of maps that are not as asked for; empty: all are.
std::string smaller_or_fewer(std::span<const Light> lights, const ShadowSettings& s, std::uint32_t side)
{
    std::string text;
    const auto casting = std::count_if(lights.begin(), lights.end(), [](const Light& l) { return l.shadow; });
    if (casting > s.max_lights)
        text = fmt::format("{} lights cast shadows, of which shadow.max_lights takes the first {}\n", casting,
                           s.max_lights);
    if (side != static_cast<std::uint32_t>(s.resolution))
        text += fmt::format("shadow maps have {} texels instead of {}: shadow.budget is {} MiB\n", side, s.resolution,
                            s.budget);
    return text;
}

/// Everything a map depends on. A map is drawn again if this differs from what it was last drawn with.
struct DrawnMap {
    std::array<shared::ShadowFace, shared::shadow_max_faces> faces{};
    std::uint32_t face_count = 0, perspective = 0;
    float depth_scale = 0, range = 0;
    vec2 texture_state{0};
};

DrawnMap drawn_from(const LightFaces& faces, const Light& light, const ShadowCasters& casters)
{
    DrawnMap out;
    std::copy(faces.faces.begin(), faces.faces.end(), out.faces.begin());
    out.face_count = static_cast<std::uint32_t>(faces.faces.size());
    out.perspective = faces.perspective ? 1 : 0;
    out.depth_scale = faces.depth_scale;
    out.range = light.range;
    out.texture_state = casters.texture_state;
    return out;
}

bool same(const shared::ShadowFace& a, const shared::ShadowFace& b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z && a.scale == b.scale;
}

std::vector<std::uint32_t> stale_faces(const std::optional<DrawnMap>& drawn, const DrawnMap& wanted)
{
    const bool keeps = drawn && drawn->face_count == wanted.face_count && drawn->perspective == wanted.perspective &&
                       drawn->depth_scale == wanted.depth_scale && drawn->range == wanted.range &&
                       drawn->texture_state == wanted.texture_state;
    std::vector<std::uint32_t> out;
    for (std::uint32_t f = 0; f < wanted.face_count; ++f) {
        if (!keeps || !same(drawn->faces[f], wanted.faces[f])) out.push_back(f);
    }
    return out;
}

std::uint64_t range_bytes(std::uint32_t side, std::uint32_t faces)
{
    const std::uint64_t cells = cells_along(side);
    return faces * cells * cells * 4 / 3 * sizeof(vec2) + sizeof(vec2);
}

/// The pipeline that draws casters of a class.
std::optional<gpu::GraphicsPipelineDesc> caster_pipeline(const MaterialClassInfo& cls)
{
    gpu::GraphicsPipelineDesc desc;
    desc.vertex = cls.has_holes ? "techniques/shadow/shadow_holes.vert" : "techniques/shadow/shadow.vert";
    if (cls.has_holes) desc.fragment = class_fragment("techniques/shadow/shadow", cls);
    desc.depth_test = gpu::DepthTest::greater_equal;
    desc.depth_write = true;
    return desc;
}

} // namespace

void ShadowMaps::tell(const std::string& text)
{
    if (text != told_ && !text.empty()) log_info(text.substr(0, text.size() - 1));
    told_ = text;
}

void ShadowMaps::make_samples(const ShadowSettings& s)
{
    const std::array counts{static_cast<std::uint32_t>(s.blocker_samples), static_cast<std::uint32_t>(s.samples)};
    if (counts == sample_counts_) return;
    sample_counts_ = counts;
    const auto all_of = [&](auto make) {
        std::vector<vec4> all; // with their distances from the middle, and one over those
        for (std::uint32_t set = 0; set < shared::sample_sets; ++set) {
            const std::uint32_t count = shared::samples_in_set(set, counts[0], counts[1]);
            for (const vec2& at : make(set, static_cast<int>(count))) {
                const float rim = glm::length(at);
                all.emplace_back(at, rim, 1 / std::max(rim, 1e-3f));
            }
        }
        return all;
    };
    const auto seed = [](std::uint32_t set) { return set == shared::set_search ? sample_seed : sample_seed + 1; };
    disc_samples_ = all_of([&](std::uint32_t set, int count) {
        if (set == shared::set_search_narrow || set == shared::set_filter_narrow) return spiral_samples(count);
        std::vector<vec2> even = disc_samples(count, seed(set));
        even_out(even);
        return even;
    });
    square_samples_ = all_of([&](std::uint32_t set, int count) {
        return set == shared::set_search ? square_samples(count, seed(set)) : lattice_samples(count);
    });
    for (vec4& at : square_samples_) at = at * 0.5f + 0.5f; // 0 to 1: shifted there
}

namespace {

graph::Buf upload_faces(graph::Graph& g, const char* name, const std::vector<LightFaces>& all)
{
    std::vector<shared::ShadowFace> table;
    for (const LightFaces& own : all) table.insert(table.end(), own.faces.begin(), own.faces.end());
    return g.upload(name, table);
}

/// One tile of a map to be drawn: its face, and where the commands of its casters begin.
struct Tile {
    std::uint32_t index = 0;
    shared::ShadowFace face{};
    std::uint32_t first_command = 0;
};

/// Draws tiles of a map, whatever way their casters face. Those not named stay as they are.
void add_tiles(graph::Graph& g, const std::string& name, const ShadowCasters& casters, const ShadowMap& map,
               graph::Buf commands, const std::vector<Tile>& tiles)
{
    graph::PassBuilder pass = g.raster(name);
    const bool all = tiles.size() == map.face_count;
    pass.depth(map.map, all ? graph::Load::clear : graph::Load::keep, 0);
    SceneDraws draws{{commands, casters.tasks.ranges, casters.tasks.count, {}}, casters.geometry};
    draws.both_sides = true;
    draws.views = static_cast<std::uint32_t>(tiles.size());
    draws.begin_view = [=, side = map.side, perspective = map.perspective ? 1u : 0u,
                        depth_scale = map.depth_scale](graph::Cmd& cmd, std::uint32_t view) {
        const uvec2 origin(tiles[view].index * side, 0);
        cmd.viewport(origin, uvec2(side));
        if (!all) cmd.clear_depth(origin, uvec2(side), 0);
        cmd.push(shared::ShadowDrawPush{tiles[view].face, perspective, depth_scale});
    };
    draw_scene(pass, draws, caster_pipeline);
}

/// What may cast into tiles, for a light that stands up to `extent` m elsewhere.
graph::Buf add_caster_culling(graph::Graph& g, const std::string& name, const ShadowCasters& casters,
                              const ShadowMap& map, const std::vector<Tile>& tiles, float range, float extent)
{
    const std::uint32_t count = casters.tasks.count;
    const graph::Buf commands =
        g.buffer(name + ".commands", std::max<std::uint64_t>(tiles.size() * count, 1) * sizeof(shared::DrawCommand));
    g.compute(name + ".cull")
        .writes(commands)
        .pipeline(gpu::ComputePipelineDesc{"techniques/shadow/shadow_cull.comp", {}})
        .record([=, perspective = map.perspective ? 1u : 0u](graph::Cmd& cmd) {
            cmd.bind();
            for (const Tile& tile : tiles) {
                cmd.push(shared::ShadowCullPush{tile.face, perspective, range, count, tile.first_command, extent});
                cmd.dispatch(count, shared::shadow_group_size);
            }
        });
    return commands;
}

void add_depth_ranges(graph::Graph& g, const std::string& name, const ShadowMap& map)
{
    const auto levels = static_cast<std::uint32_t>(std::bit_width(map.cells));
    for (std::uint32_t level = 0; level < levels; ++level) {
        const shared::DepthRangePush push{map.side, map.face_count, level, map.cells};
        graph::PassBuilder pass = g.compute(fmt::format("{}.ranges.{}", name, level));
        if (level == 0)
            pass.reads(map.map).writes(map.ranges);
        else
            pass.updates(map.ranges);
        pass
            .pipeline(gpu::ComputePipelineDesc{
                level == 0 ? "techniques/shadow/depth_range_base.comp" : "techniques/shadow/depth_range.comp", {}})
            .record([push](graph::Cmd& cmd) {
                const std::uint32_t along = push.cells >> push.level;
                cmd.bind();
                cmd.push(push);
                cmd.dispatch(push.faces * along * along, shared::shadow_group_size);
            });
    }
}

std::vector<Tile> tiles_of(const LightFaces& faces, const std::vector<std::uint32_t>& which, std::uint32_t task_count)
{
    std::vector<Tile> tiles;
    for (const std::uint32_t f : which)
        tiles.push_back({f, faces.faces[f], static_cast<std::uint32_t>(tiles.size()) * task_count});
    return tiles;
}

/// A map as the shaders know it.
ShadowMap describe_map(std::uint32_t light, const LightFaces& faces, std::uint32_t side, std::uint32_t first_face)
{
    ShadowMap map;
    map.light = light;
    map.side = side;
    map.cells = cells_along(side);
    map.first_face = first_face;
    map.face_count = static_cast<std::uint32_t>(faces.faces.size());
    map.perspective = faces.perspective;
    map.depth_scale = faces.depth_scale;
    map.near = faces.near;
    map.scale = faces.faces.front().scale;
    return map;
}

} // namespace

ShadowMapSet ShadowMaps::add(graph::Graph& g, const ShadowCasters& casters, const LightSet& set, const View& view,
                             const ShadowSettings& s)
{
    const std::span<const Light> lights = set.lights;
    const std::vector<std::uint32_t>& shadowed = set.shadowed;
    ShadowMapSet out;
    if (shadowed.empty()) return out;
    const std::uint32_t side = affordable_side(lights, shadowed, s, device_.report().widest_image);
    tell(smaller_or_fewer(lights, s, side));
    std::vector<LightFaces> all;
    for (const std::uint32_t i : shadowed)
        all.push_back(light_faces(lights[i], casters.bounds, {view.camera, view.aspect, s.cascades, side},
                                  extent_of(lights[i], s)));
    make_samples(s);
    out.faces = upload_faces(g, "shadow.faces", all);
    out.disc_samples = g.upload("shadow.disc_samples", disc_samples_);
    out.square_samples = g.upload("shadow.square_samples", square_samples_);

    std::uint32_t first_face = 0;
    for (std::size_t k = 0; k < shadowed.size(); ++k) {
        const Light& light = lights[shadowed[k]];
        const LightFaces& faces = all[k];
        const auto count = static_cast<std::uint32_t>(faces.faces.size());
        const std::string name = fmt::format("shadow.{}", shadowed[k]);
        const std::string key = fmt::format("shadow map {:x}", set.keys[shadowed[k]]); // whatever its index
        ShadowMap map = describe_map(shadowed[k], faces, side, first_face);
        map.map = g.persistent(name, {gpu::Format::depth32, side * count, side}, {graph::Owner::scene, key});
        map.ranges = g.persistent(name + ".ranges", range_bytes(side, count), {graph::Owner::scene, key + " ranges"});
        const DrawnMap wanted = drawn_from(faces, light, casters);
        const bool kept = s.cache && g.holds(map.ranges);
        const std::vector<std::uint32_t> stale = stale_faces(kept ? g.noted<DrawnMap>(map.map) : std::nullopt, wanted);
        g.note(map.map, wanted);
        if (!stale.empty()) {
            const std::vector<Tile> tiles = tiles_of(faces, stale, casters.tasks.count);
            add_tiles(g, name, casters, map, add_caster_culling(g, name, casters, map, tiles, light.range, 0), tiles);
            add_depth_ranges(g, name, map);
        }
        first_face += count;
        out.maps.push_back(map);
    }
    return out;
}

graph::Tex ShadowMaps::add_reference(graph::Graph& g, graph::Tex depth, graph::Tex normal, const ShadowCasters& casters,
                                     const LightSet& lights, const View& view, const ShadowMapSet& set,
                                     const ShadowSettings& s)
{
    if (set.maps.empty()) return g.constant_array(1);
    const auto light_count = static_cast<std::uint32_t>(set.maps.size());
    const std::uint32_t points = std::clamp(static_cast<std::uint32_t>(s.reference_points), 1u,
                                            std::max(reference_passes / (2 * light_count), 1u));
    const graph::Tex visibility = create_visibility(g, depth, light_count);
    ShadowSettings hard = s;
    hard.filter = ShadowFilter::hard;
    const float weight = 1 / static_cast<float>(points);

    std::vector<Light> moved; // each light at each of its points
    std::vector<LightFaces> all;
    for (const ShadowMap& map : set.maps) {
        const CascadeFit fit{view.camera, view.aspect, s.cascades, map.side};
        for (std::uint32_t p = 0; p < points; ++p) {
            moved.push_back(at_point(lights.lights[map.light], s.softness, p));
            all.push_back(light_faces(moved.back(), casters.bounds, fit, 0));
        }
    }
    ShadowMapSet moved_set = set;
    moved_set.faces = upload_faces(g, "shadow.reference.faces", all);

    std::uint32_t first_face = 0;
    for (std::uint32_t k = 0; k < light_count; ++k) {
        const std::uint32_t index = set.maps[k].light, side = set.maps[k].side;
        const Light& light = lights.lights[index];
        const std::string name = fmt::format("shadow.{}.reference", index);
        const graph::Tex map_image = g.texture(name, {gpu::Format::depth32, side * set.maps[k].face_count, side});
        const float extent = light_extent(light, s.softness);
        std::vector<std::uint32_t> every(set.maps[k].face_count);
        std::iota(every.begin(), every.end(), 0u);
        graph::Buf commands;
        for (std::uint32_t p = 0; p < points; ++p) {
            const LightFaces& faces = all[k * points + p];
            ShadowMap map = describe_map(index, faces, side, first_face);
            first_face += map.face_count;
            map.map = map_image;
            map.ranges = set.maps[k].ranges;
            const std::vector<Tile> tiles = tiles_of(faces, every, casters.tasks.count);
            if (p == 0) {
                const float reach = light.type == LightType::sun ? 2 * extent * casters.bounds.diagonal() : 2 * extent;
                commands = add_caster_culling(g, name, casters, map, tiles, light.range, reach);
            }
            add_tiles(g, name, casters, map, commands, tiles);
            add_visibility(g, depth, normal, moved_set, map, moved[k * points + p], hard, shared::show_visibility,
                           {fmt::format("visibility.{}", index), visibility, k,
                            p == 0 ? graph::Load::clear : graph::Load::keep, weight, light.position});
        }
    }
    return visibility;
}

} // namespace atrium
