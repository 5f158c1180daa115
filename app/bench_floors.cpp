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

/// Reads the targets that lighting reads and writes one.
void add_lighting_floor(graph::Graph& g, const GBuffer& gb)
{
    graph::TexDesc desc = g.desc(gb.depth);
    desc.format = gpu::Format::rgba16_float;
    const graph::Tex target = g.texture("floor.lighting", desc);
    graph::PassBuilder pass = g.raster("floor.lighting");
    reads(pass, gb).writes(target).always().fullscreen("techniques/bench/gbuffer_read.frag");
}

/// As many depths as ambient occlusion reads.
void add_ao_floor(graph::Graph& g, const GBuffer& gb, int taps)
{
    graph::TexDesc desc = g.desc(gb.depth);
    desc.format = gpu::Format::rg32_float;
    const graph::Tex target = g.texture("floor.ao_taps", desc);
    graph::PassBuilder pass = g.raster("floor.ao_taps");
    reads(pass, gb).writes(target).always().fullscreen("techniques/bench/ao_taps.frag",
                                                       {static_cast<std::uint32_t>(taps)});
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
    graph::Graph g;
    const GpuScene& scene = engine.scene();
    const GBuffer gb =
        add_culled_gbuffer(g, scene.tasks(), scene.geometry(), request.size, request.settings.culling).gbuffer;
    add_lighting_floor(g, gb);
    if (request.settings.ao.method != AoMethod::off) add_ao_floor(g, gb, request.settings.ao.samples);
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
