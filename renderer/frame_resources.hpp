#pragma once
// What the host writes for one frame in flight and reads after it: the buffers of set 1 and the readbacks. Its timers
// and uploads are in graph::FrameSlot. There is one; more frames in flight would each have an object of this type.

#include "renderer/gpu/descriptors.hpp"
#include "renderer/gpu_scene.hpp"
#include "renderer/graph/graph.hpp"
#include "shaders/shared/frame.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace atrium {

/// Buffers from which the CPU reads results; their memory is kept from frame to frame.
class Readbacks {
public:
    explicit Readbacks(const gpu::Device& device) : device_(device) {}
    /// The buffers of the previous frame may be used again.
    void begin() { used_ = 0; }
    /// Adds a pass `readback.NAME` that copies all texels, or the first bytes, to a buffer that the CPU can read after
    /// the graph has run.
    const gpu::Buffer& add(graph::Graph& g, graph::Tex texture, const std::string& name);
    const gpu::Buffer& add(graph::Graph& g, graph::Buf from, std::uint64_t bytes, const std::string& name);

private:
    const gpu::Buffer& next(std::uint64_t bytes);
    const gpu::Device& device_;
    std::vector<std::unique_ptr<gpu::Buffer>> buffers_;
    std::size_t used_ = 0;
};

/// The contents of a buffer that was read back.
[[nodiscard]] std::span<const std::byte> bytes_in(const gpu::Buffer& buffer);

class FrameResources {
public:
    FrameResources(const gpu::Device& device, gpu::Descriptors& descriptors);

    Readbacks readbacks;

    /// Makes the tables of a scene; without a scene, releases those of the last.
    void set_scene(const GpuScene* scene);
    void write(const shared::FrameConstants& values);
    /// Writes the scene's draw order, and its materials and records if they are not those written last.
    void write(const GpuScene& scene);

private:
    [[nodiscard]] gpu::Buffer make_table(gpu::FrameBinding binding, const char* name, std::uint64_t bytes);
    const gpu::Device& device_;
    gpu::Descriptors& descriptors_;
    gpu::Buffer constants_; ///< shared::FrameConstants
    gpu::Buffer draw_order_, materials_, records_;
    std::uint64_t scene_version_ = 0; ///< GpuScene::version() of materials_ and records_
};

} // namespace atrium
