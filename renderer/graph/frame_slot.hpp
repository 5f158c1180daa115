#pragma once
// What a frame in flight owns below the graph: its timestamps, and the memory of what the host writes for it.

#include "renderer/gpu/resources.hpp"
#include "renderer/gpu/timers.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace atrium::graph {

/// Buffers that the host writes for one frame; their memory is kept from frame to frame.
class Uploads {
public:
    explicit Uploads(const gpu::Device& device) : device_(device) {}
    /// The buffers given out so far may be used again: the device has read them.
    void begin() { used_ = 0; }
    /// A mapped buffer of at least that size, for vertices, indices, indirect commands and storage.
    [[nodiscard]] const gpu::Buffer& next(std::uint64_t bytes);

private:
    const gpu::Device& device_;
    std::vector<std::unique_ptr<gpu::Buffer>> buffers_;
    std::size_t used_ = 0;
};

/// A runner has one, because it waits for each frame; more frames in flight would each have their own.
struct FrameSlot {
    explicit FrameSlot(const gpu::Device& device);
    gpu::Timers timers;
    Uploads uploads;
};

} // namespace atrium::graph
