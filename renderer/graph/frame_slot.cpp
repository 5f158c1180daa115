#include "renderer/graph/frame_slot.hpp"

#include "renderer/gpu/descriptors.hpp"
#include "renderer/graph/transients.hpp"

#include <algorithm>
#include <bit>

namespace atrium::graph {

const gpu::Buffer& Uploads::next(std::uint64_t bytes)
{
    constexpr std::uint64_t smallest = 4096;
    if (used_ == buffers_.size()) buffers_.emplace_back();
    std::unique_ptr<gpu::Buffer>& buffer = buffers_[used_++];
    if (!buffer || buffer->size() < bytes) {
        buffer = std::make_unique<gpu::Buffer>(device_, "upload", std::bit_ceil(std::max(bytes, smallest)),
                                               buffer_usage, gpu::MemoryUse::upload);
    }
    return *buffer;
}

FrameSlot::FrameSlot(const gpu::Device& device) : timers(device, gpu::Descriptors::max_passes), uploads(device) {}

} // namespace atrium::graph
