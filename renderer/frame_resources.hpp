#pragma once
// What one frame in flight writes on the host's side, and what it leaves there. There is one frame in flight; with more
// of them there are more of these, and nothing else that the host writes for a frame.

#include "renderer/gpu/resources.hpp"
#include "renderer/graph/graph.hpp"
#include "shaders/shared/frame.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace atrium {

/// Buffers that the CPU reads results from, kept from frame to frame.
class Readbacks {
public:
    explicit Readbacks(const gpu::Device& device) : device_(device) {}
    /// Those of the frame before may be used again.
    void begin() { used_ = 0; }
    /// Adds a pass `readback.NAME` that copies all texels, or the first bytes, to where the CPU reads them once the
    /// graph has run.
    const gpu::Buffer& add(graph::Graph& g, graph::Tex texture, const std::string& name);
    const gpu::Buffer& add(graph::Graph& g, graph::Buf from, std::uint64_t bytes, const std::string& name);

private:
    const gpu::Buffer& next(std::uint64_t bytes);
    const gpu::Device& device_;
    std::vector<std::unique_ptr<gpu::Buffer>> buffers_;
    std::size_t used_ = 0;
};

/// What the device left in a buffer that is read back.
[[nodiscard]] std::span<const std::byte> bytes_in(const gpu::Buffer& buffer);

class FrameResources {
public:
    explicit FrameResources(const gpu::Device& device);

    gpu::Buffer constants; ///< shared::FrameConstants
    Readbacks readbacks;

    void write(const shared::FrameConstants& values);
};

} // namespace atrium
