#include "app/bench_floors.hpp"

#include "app/stats.hpp"
#include "renderer/core/error.hpp"

#include <sys/mman.h>

#include <cstring>

namespace atrium::app {
namespace {

using graph::Load;

/// The real opaque and masked shaders over whole meshes in the bake's order: no culling of any kind, one draw each.
void add_gbuffer_floor(graph::Graph& g, const GpuScene& scene, uvec2 size)
{
    const graph::Buf commands = g.import("whole_meshes", scene.whole_meshes(), gpu::Access::indirect_read);
    const DrawList whole{commands, scene.whole_mesh_ranges(), 0, {}};
    const GBuffer gb = add_gbuffer(g, whole, scene.geometry(), size, "floor.gbuffer");
    const graph::Tex sink = g.texture("floor.gbuffer.sink", g.desc(gb.albedo));
    g.raster("floor.gbuffer.sink").reads(gb.albedo).writes(sink, Load::clear).always();
}

/// Reads the targets that lighting reads, visibility of so many lights among them, and writes one.
void add_lighting_floor(graph::Graph& g, const GBuffer& gb, std::size_t shadowed)
{
    const graph::Tex visibility = shadowed > 0 ? create_visibility(g, gb.depth, shadowed) : g.constant_array(1);
    for (std::uint32_t layer = 0; layer < shadowed; ++layer)
        g.raster("floor.lighting.visibility").writes_layer(visibility, layer, Load::clear, vec4(1));
    graph::TexDesc desc = g.desc(gb.depth);
    desc.format = gpu::Format::rgba16_float;
    const graph::Tex target = g.texture("floor.lighting", desc);
    graph::PassBuilder pass = g.raster("floor.lighting");
    reads(pass, gb)
        .reads(visibility)
        .writes(target)
        .always()
        .fullscreen("techniques/bench/gbuffer_read.frag", {static_cast<std::uint32_t>(shadowed)});
}

/// As many depths as ambient occlusion reads.
void add_ao_floor(graph::Graph& g, const GBuffer& gb, int taps)
{
    graph::TexDesc desc = g.desc(gb.depth);
    desc.format = gpu::Format::rg32_float;
    const graph::Tex target = g.texture("floor.ao_taps", desc);
    g.raster("floor.ao_taps")
        .reads(gb.depth)
        .reads(gb.normal)
        .writes(target)
        .always()
        .fullscreen("techniques/bench/ao_taps.frag", {static_cast<std::uint32_t>(taps)});
}

/// As many depths as the shadows of a light read and compare, from a map of their format through their samplers.
void add_shadow_floor(graph::Graph& g, uvec2 size, const ShadowSettings& s)
{
    const auto side = static_cast<std::uint32_t>(s.resolution);
    const graph::Tex map = g.texture("floor.shadow_taps.map", {gpu::Format::depth32, side, side});
    const graph::Tex target = g.texture("floor.shadow_taps", {gpu::Format::r32_float, size.x, size.y});
    const int plain = s.filter == ShadowFilter::pcss ? s.blocker_samples : 0;
    const int compared = s.filter == ShadowFilter::hard ? 1 : s.samples;
    g.raster("floor.shadow_taps.map").depth(map, Load::clear, 0.5f);
    g.raster("floor.shadow_taps")
        .reads(map)
        .writes(target)
        .always()
        .fullscreen("techniques/bench/shadow_taps.frag",
                    {static_cast<std::uint32_t>(plain), static_cast<std::uint32_t>(compared)});
}

/// 16 bilinear taps of an RGBA8 image at each pixel.
void add_t16_floor(graph::Graph& g, uvec2 size)
{
    const graph::TexDesc desc{gpu::Format::rgba8_unorm, size.x, size.y};
    const graph::Tex source = g.texture("floor.t16.source", desc), target = g.texture("floor.t16", desc);
    g.raster("floor.t16.source").writes(source, Load::clear, vec4(0.5f));
    g.raster("floor.t16").reads(source).writes(target).always().fullscreen("techniques/bench/t16.frag");
}

} // namespace

std::map<std::string, double> run_device_floors(Engine& engine, const FrameRequest& request)
{
    engine.set_frame_constants(request);
    graph::Graph g(engine.runner(), {request.size, request.size, "floors"});
    const GpuScene& scene = engine.scene();
    const GBuffer gb =
        add_culled_gbuffer(g, scene.tasks(), scene.geometry(), request.size, request.settings.culling).gbuffer;
    const std::size_t shadowed =
        make_light_set(request.lights, most_shadowed_lights(request.settings.shadow)).shadowed.size();
    add_lighting_floor(g, gb, shadowed);
    if (request.settings.ao.method != AoMethod::off) add_ao_floor(g, gb, request.settings.ao.samples);
    if (shadowed > 0) add_shadow_floor(g, request.size, request.settings.shadow);
    add_gbuffer_floor(g, scene, request.size);
    add_t16_floor(g, request.size);
    std::map<std::string, double> floors;
    for (const graph::PassStats& pass : engine.runner().run(g, gpu::TimerMode::serialized).passes)
        floors[pass.name] = pass.gpu_ms;
    return floors;
}

BulkRange bulk_range(const BakeFile& bake)
{
    const std::span<const std::byte> whole = bake.bytes(), first = bake.vertices(), last = bake.texels();
    const auto offset = static_cast<std::uint64_t>(first.data() - whole.data());
    return {offset, static_cast<std::uint64_t>(last.data() + last.size() - first.data())};
}

double run_copy_floor(const std::filesystem::path& bake, const BulkRange& bulk)
{
    const auto start = std::chrono::steady_clock::now();
    const MappedFile file(bake);
    const std::span<const std::byte> bytes = file.bytes().subspan(bulk.offset, bulk.size);
    void* memory = mmap(nullptr, bytes.size(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        throw Error(ExitCode::environment, "no memory for floor.copy", bake.string(), std::strerror(errno),
                    "use a smaller scene");
    std::memcpy(memory, bytes.data(), bytes.size());
    const double ms = ms_since(start);
    munmap(memory, bytes.size());
    return ms;
}

} // namespace atrium::app
