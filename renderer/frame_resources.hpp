#pragma once
// The uniform buffer and the readbacks of one frame in flight. There is one; more frames in flight would each have an
// object of this type. Not in here yet, although the host writes or reads them for each frame: draw order and records
// (GpuScene), shadow faces (ShadowMaps), triangles of the interface (Ui), timers (graph::Runner).

#include "renderer/gpu/resources.hpp"
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
    explicit FrameResources(const gpu::Device& device);

    gpu::Buffer constants; ///< shared::FrameConstants
    Readbacks readbacks;

    void write(const shared::FrameConstants& values);
};

} // namespace atrium
