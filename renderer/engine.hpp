#pragma once
// The renderer's public API: a device, a scene on it, frames of it as images in host memory.

#include "renderer/core/image.hpp"
#include "renderer/frame.hpp"
#include "renderer/frame_request.hpp"
#include "renderer/gpu/swapchain.hpp"
#include "renderer/graph/runner.hpp"
#include "renderer/graph_facts.hpp"
#include "renderer/scene/camera.hpp"
#include "renderer/scene/light.hpp"
#include "renderer/settings.hpp"
#include "renderer/ui.hpp"
#include "shaders/embedded.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace atrium {

struct EngineOptions {
    std::string device;                 ///< name or index; empty: the best one
    bool validate = false;              ///< Khronos validation with synchronisation checks
    std::filesystem::path cache_folder; ///< for the driver's pipeline cache; empty: none
    UploadPath upload = UploadPath::automatic;
    gpu::ShaderLookup shaders = shaders::find; ///< those embedded in the program
    gpu::WindowSystem window;                  ///< empty: frames go to host memory only
};

/// What to draw. Bakes are mapped by the caller and may go once load() has returned.
struct SceneDescription {
    std::vector<const BakeFile*> bakes;
    std::vector<Instance> instances;
    std::vector<MaterialOverride> overrides;
};

struct FrameResult {
    Image8 picture; ///< RGB
    ImageF hdr;     ///< linear, before exposure
    std::vector<ImageF> aovs;
    std::vector<BufferFacts> buffers; ///< shown: the one in place of the picture, if any, then the insets
    graph::RunStats stats;
    GraphFacts graph;
    double record_ms = 0;               ///< CPU time to build, plan and record the frame
    std::uint64_t triangles = 0;        ///< drawn after culling
    std::uint32_t material_changes = 0; ///< between neighbouring visible draws
};

struct ShowResult {
    bool done = false;       ///< else the window has changed in between; the next window_size() tells how
    double picture_ms = 0;   ///< bringing the pictures into the window
    double interface_ms = 0; ///< drawing the user interface over them
};

class Engine {
public:
    explicit Engine(const EngineOptions& options);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Replaces the scene.
    void load(const SceneDescription& scene);
    void unload();
    /// Other SPIR-V for a shader, from the next frame on. Throws Error, and leaves all as it was, where it does not fit
    /// what the program was built for.
    void replace_shader(const std::string& name, std::span<const std::uint32_t> code);
    /// Draws one frame and waits for it.
    [[nodiscard]] FrameResult render(const FrameRequest& request);

    /// The channels of a buffer that the last frame showed, by its place in FrameResult::buffers, at a point of it (0
    /// to 1, from the upper left); empty where that frame was to keep none.
    [[nodiscard]] std::vector<float> buffer_value(std::size_t buffer, vec2 at) const;

    /// RGBA8 of what user interfaces are written with, rows from the top. Before the first show().
    void set_ui_font(uvec2 size, std::span<const std::byte> rgba);
    /// Makes ready for a window of so many pixels. Returns the size that it has, for which an interface is to be drawn;
    /// (0, 0): it is minimised, and show() must wait.
    [[nodiscard]] uvec2 window_size(uvec2 wanted, gpu::PresentMode mode);
    /// Whether the window offers that mode; else it has PresentMode::on.
    [[nodiscard]] bool has_wanted_mode() const;
    /// Shows the pictures kept last under a user interface: the main one, and left of `divider` (pixels) the other.
    ShowResult show(const UiDraws& ui, float divider = 0);

    [[nodiscard]] const gpu::Device& device() const;
    [[nodiscard]] const GpuScene& scene() const;
    [[nodiscard]] graph::Runner& runner();
    [[nodiscard]] std::size_t validation_messages() const;
    /// Writes the frame's constants and draw order, as render() does: for benchmarks that run graphs of their own.
    void set_frame_constants(const FrameRequest& request);
    [[nodiscard]] gpu::Descriptors& descriptors();

private:
    void forget_frames(); ///< what outlives a frame on the device
    [[nodiscard]] View view_of(const FrameRequest& request) const;
    void write_frame(const View& view, const LightSet& lights, const Settings& settings);
    void keep_shown(graph::Graph& g, const Frame& frame, const FrameRequest& request);
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace atrium
