#include "renderer/engine.hpp"

#include "renderer/core/error.hpp"
#include "renderer/core/log.hpp"
#include "renderer/frame_constants.hpp"
#include "renderer/frame_resources.hpp"
#include "renderer/techniques/lighting/ltc_table.hpp"
#include "shaders/shared/buffer_view.h"

#include <fmt/format.h>

#include <glm/gtc/packing.hpp>

#include <array>
#include <chrono>
#include <cstring>
#include <map>
#include <span>
#include <stdexcept>

namespace atrium {
namespace {

/// First `channels` of each texel, as floats times `scale`.
ImageF to_image(std::span<const std::byte> bytes, const graph::TexDesc& desc, int channels, float scale)
{
    ImageF image(static_cast<int>(desc.width), static_cast<int>(desc.height), channels);
    const std::size_t texels = std::size_t{desc.width} * desc.height;
    const std::size_t stored = desc.format == gpu::Format::r32_float ? 1 : 4;
    const bool halves = desc.format == gpu::Format::rgba16_float;
    for (std::size_t t = 0; t < texels; ++t) {
        for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
            const std::size_t i = stored * t + c;
            float value = 0;
            if (halves) {
                std::uint16_t half = 0;
                std::memcpy(&half, bytes.data() + 2 * i, 2);
                value = glm::unpackHalf1x16(half);
            } else {
                std::memcpy(&value, bytes.data() + 4 * i, 4);
            }
            image.values[t * static_cast<std::size_t>(channels) + c] = value * scale;
        }
    }
    return image;
}

Image8 to_picture(std::span<const std::byte> rgba, const graph::TexDesc& desc)
{
    Image8 image(static_cast<int>(desc.width), static_cast<int>(desc.height), 3);
    const std::size_t texels = std::size_t{desc.width} * desc.height;
    for (std::size_t t = 0; t < texels; ++t) std::memcpy(&image.values[3 * t], rgba.data() + 4 * t, 3);
    return image;
}

const gpu::Buffer& read_back(graph::Graph& g, Readbacks& readbacks, const DrawList& draws)
{
    return readbacks.add(g, draws.commands, draws.count * sizeof(shared::DrawCommand), "draws");
}

BufferFacts facts_of(std::span<const std::byte> bytes, const ShownBuffer& shown)
{
    shared::BufferStatistics s{};
    std::memcpy(&s, bytes.data(), sizeof(s));
    return {s.low, s.sum / static_cast<float>(s.count), s.high, s.range, shown.mode, s.count, shown.absent};
}

/// Values of a buffer that is shown, left where the CPU reads them.
struct KeptBuffer {
    const gpu::Buffer* values = nullptr;
    graph::TexDesc desc;
    int channels = 1;
};

} // namespace

struct Engine::State {
    explicit State(const EngineOptions& o)
        : options(o), instance(o.validate, o.window.instance_extensions),
          device(instance, gpu::choose_device(instance, o.device), static_cast<bool>(o.window)), descriptors(device),
          pipelines(device, descriptors, o.shaders, o.cache_folder), runner(device, descriptors, pipelines),
          frame(device, descriptors), kept_readbacks(device), shadow_maps(device), ui(device),
          ltc(device, "ltc", ltc_table().size_bytes(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::MemoryUse::upload)
    {
        ltc.write(ltc_table());
        descriptors.set_frame_buffer(gpu::FrameBinding::ltc, ltc);
        if (o.window) swapchain = std::make_unique<gpu::Swapchain>(instance, device, o.window);
    }
    EngineOptions options;
    gpu::Instance instance;
    gpu::Device device;
    gpu::Descriptors descriptors;
    gpu::Pipelines pipelines;
    graph::Runner runner;
    FrameResources frame;                 ///< of the frame in flight
    Readbacks kept_readbacks;             ///< of kept_buffers, which stay from frame to frame
    std::vector<KeptBuffer> kept_buffers; ///< of the picture kept last
    ShadowMaps shadow_maps;
    Ui ui;
    std::unique_ptr<gpu::Swapchain> swapchain; ///< where there is a window
    bool swapchain_stale = true;
    gpu::PresentMode present_mode = gpu::PresentMode::on;
    gpu::Buffer ltc; ///< the table of area lights
    std::unique_ptr<GpuScene> scene;
    std::array<std::optional<float>, 2> last_exposures; ///< by PictureSlot: exposure of the last frame of each view
    std::unique_ptr<Renderer> renderer;
    RenderPath path = RenderPath::deferred;
};

Engine::Engine(const EngineOptions& options) : state_(std::make_unique<State>(options)) {}
Engine::~Engine() = default;

const gpu::Device& Engine::device() const
{
    return state_->device;
}
const GpuScene& Engine::scene() const
{
    return *state_->scene;
}
graph::Runner& Engine::runner()
{
    return state_->runner;
}
gpu::Descriptors& Engine::descriptors()
{
    return state_->descriptors;
}
std::size_t Engine::validation_messages() const
{
    return state_->instance.validation().count();
}

void Engine::load(const SceneDescription& scene)
{
    unload();
    state_->scene = std::make_unique<GpuScene>(state_->device, state_->descriptors, scene.bakes, scene.instances,
                                               scene.overrides, state_->options.upload);
    state_->frame.set_scene(state_->scene.get());
}

void Engine::set_ui_font(uvec2 size, std::span<const std::byte> rgba)
{
    state_->ui.set_font(size, rgba);
}

uvec2 Engine::window_size(uvec2 wanted, gpu::PresentMode mode)
{
    State& s = *state_;
    if (!s.swapchain) throw std::logic_error("window_size() without a window");
    if (s.swapchain_stale || mode != s.present_mode || wanted != s.swapchain->size()) {
        s.swapchain_stale = !s.swapchain->resize(wanted, mode);
        s.present_mode = mode;
    }
    return s.swapchain->size();
}

bool Engine::has_wanted_mode() const
{
    return state_->swapchain->has_wanted_mode();
}

ShowResult Engine::show(const UiDraws& ui, float divider)
{
    ShowResult result;
    State& s = *state_;
    const std::optional<gpu::Swapchain::Target> target = s.swapchain->acquire();
    if (target) {
        graph::Graph g(s.runner, {.view = "window"});
        const graph::Tex window = g.import("window", *target->image);
        s.ui.add_pictures(g, window, divider);
        s.ui.add(g, window, ui);
        g.keep(window, gpu::Access::present);
        const graph::RunStats stats = s.runner.run(g, gpu::TimerMode::overlapped, target->sync);
        result.picture_ms = stats.passes.front().gpu_ms;
        result.interface_ms = stats.wall_ms - result.picture_ms;
    }
    s.swapchain_stale = !target || !s.swapchain->present();
    result.done = !s.swapchain_stale;
    return result;
}

void Engine::unload()
{
    forget_frames();
    state_->frame.set_scene(nullptr);
    state_->scene.reset();
}

void Engine::replace_shader(const std::string& name, std::span<const std::uint32_t> code)
{
    state_->pipelines.replace(name, code);
    forget_frames();
}

void Engine::forget_frames()
{
    state_->runner.forget();
    state_->last_exposures = {};
}

namespace {

/// The view of a request: the second picture of a split view has its own history.
PictureSlot slot_of(const FrameRequest& request)
{
    return request.keep_picture.value_or(PictureSlot::main);
}

} // namespace

View Engine::view_of(const FrameRequest& request) const
{
    ViewDescription description = describe_view(request, state_->scene->bounds());
    const std::optional<float>& last = state_->last_exposures[static_cast<std::size_t>(slot_of(request))];
    description.cut = request.cut || !last;
    description.previous_exposure = last.value_or(description.exposure);
    return make_view(description);
}

void Engine::set_frame_constants(const FrameRequest& request)
{
    write_frame(view_of(request), make_light_set(request.lights, most_shadowed_lights(request.settings.shadow)),
                request.settings);
}

void Engine::write_frame(const View& view, const LightSet& lights, const Settings& settings)
{
    State& s = *state_;
    s.descriptors.set_material_filter(settings.texture.anisotropy, 0);
    s.scene->sort_for(view.camera.eye);
    s.frame.write(*s.scene);
    s.frame.write(make_frame_constants(view, lights, settings));
}

namespace {

/// What the commands that the GPU left after culling draw.
void count_draws(std::span<const std::byte> bytes, const GpuScene& scene, FrameResult& result)
{
    const auto* commands = reinterpret_cast<const shared::DrawCommand*>(bytes.data());
    std::optional<std::uint32_t> material;
    for (std::uint32_t i = 0; i < scene.tasks().count; ++i) {
        if (commands[i].instance_count == 0) continue;
        result.triangles += commands[i].index_count / 3;
        const std::uint32_t own = scene.material_of_task(i);
        if (material && *material != own) ++result.material_changes;
        material = own;
    }
}

} // namespace

void Engine::keep_shown(graph::Graph& g, const Frame& frame, const FrameRequest& request)
{
    State& s = *state_;
    s.ui.keep_picture(g, frame.picture, *request.keep_picture);
    if (request.keep_picture != PictureSlot::main) return;
    if (frame.insets) s.ui.keep_insets(g, frame.insets);
    s.kept_readbacks.begin();
    s.kept_buffers.clear();
    if (!request.keep_buffers) return;
    for (std::size_t i = 0; i < frame.shown.size(); ++i) {
        const graph::Tex values = frame.shown[i].values;
        s.kept_buffers.push_back(
            {&s.kept_readbacks.add(g, values, fmt::format("buffer.{}", i)), g.desc(values), frame.shown[i].channels});
    }
}

std::vector<float> Engine::buffer_value(std::size_t buffer, vec2 at) const
{
    if (buffer >= state_->kept_buffers.size()) return {};
    const KeptBuffer& kept = state_->kept_buffers[buffer];
    const uvec2 size(kept.desc.width, kept.desc.height);
    const uvec2 texel = glm::min(uvec2(glm::max(at, vec2(0)) * vec2(size)), size - 1u);
    const std::size_t stored = kept.desc.format == gpu::Format::r32_float ? 1 : 4;
    std::vector<float> out(static_cast<std::size_t>(kept.channels));
    const std::size_t first = (std::size_t{texel.y} * size.x + texel.x) * stored * sizeof(float);
    std::memcpy(out.data(), kept.values->mapped().data() + first, out.size() * sizeof(float));
    return out;
}

FrameResult Engine::render(const FrameRequest& request)
{
    State& s = *state_;
    if (!s.scene) throw std::logic_error("render() before load()");
    const auto start = std::chrono::steady_clock::now();
    if (!s.renderer || s.path != request.settings.renderer.path) {
        s.path = request.settings.renderer.path;
        s.renderer = make_renderer(s.path);
    }
    if (s.scene->override_materials(request.materials)) forget_frames();
    s.scene->set_previous_instances(request.previous_instances);
    const View view = view_of(request);
    const LightSet lights = make_light_set(request.lights, most_shadowed_lights(request.settings.shadow));
    write_frame(view, lights, request.settings);

    graph::Graph g(s.runner, {view.render_size, view.output_size,
                              slot_of(request) == PictureSlot::other ? "other" : "main", view.cut});
    const FrameContext context{request.settings,
                               *s.scene,
                               view,
                               lights,
                               &s.shadow_maps,
                               request.remember,
                               s.device.report().optional.lines,
                               &request.insets,
                               request.outlined,
                               request.keep_picture.has_value()}; // in a window, what is shown outlives techniques
    const Frame frame = build_frame(g, *s.renderer, context, request.aovs);

    Readbacks& readbacks = s.frame.readbacks;
    readbacks.begin();
    const gpu::Buffer* picture = nullptr;
    const gpu::Buffer* hdr = nullptr;
    std::vector<const gpu::Buffer*> commands;
    std::vector<const gpu::Buffer*> aovs;
    std::vector<const gpu::Buffer*> statistics;
    if (request.keep_picture) keep_shown(g, frame, request);
    for (const ShownBuffer& b : frame.shown)
        statistics.push_back(&readbacks.add(g, b.statistics, sizeof(shared::BufferStatistics), "statistics"));
    if (request.want_picture) picture = &readbacks.add(g, frame.picture, "picture");
    if (request.want_hdr) hdr = &readbacks.add(g, frame.hdr, "hdr");
    for (std::size_t i = 0; i < frame.aovs.size(); ++i) {
        aovs.push_back(&readbacks.add(g, frame.aovs[i].values, fmt::format("aov.{}", i)));
    }
    if (request.want_statistics && s.scene->tasks().count > 0) {
        for (const DrawList& draws : frame.draws) commands.push_back(&read_back(g, readbacks, draws));
    }

    FrameResult result;
    const double built_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    result.stats = s.runner.run(g, request.timers);
    result.record_ms = built_ms + result.stats.cpu_ms;
    s.last_exposures[static_cast<std::size_t>(slot_of(request))] = view.exposure;
    if (request.want_graph) result.graph = make_graph_facts(g, frame, s.runner, result.stats);

    const float unexpose = 1.0f / view.exposure;
    if (picture) result.picture = to_picture(bytes_in(*picture), g.desc(frame.picture));
    if (hdr) result.hdr = to_image(bytes_in(*hdr), g.desc(frame.hdr), 3, unexpose);
    for (std::size_t i = 0; i < aovs.size(); ++i) {
        const AovImage& aov = frame.aovs[i];
        result.aovs.push_back(to_image(bytes_in(*aovs[i]), g.desc(aov.values), aov.info->channels, 1));
    }
    for (std::size_t i = 0; i < statistics.size(); ++i)
        result.buffers.push_back(facts_of(bytes_in(*statistics[i]), frame.shown[i]));
    for (const KeptBuffer& kept : s.kept_buffers) kept.values->invalidate();
    for (const gpu::Buffer* list : commands) count_draws(bytes_in(*list), *s.scene, result);
    return result;
}

} // namespace atrium
