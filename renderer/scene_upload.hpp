#pragma once
// Bulk data from mapped bakes into device memory.

#include "renderer/gpu/resources.hpp"

#include <span>
#include <vector>

namespace atrium {

/// How bulk data reach the device.
enum class UploadPath {
    automatic, ///< import where the device can, else staging
    staging,   ///< always through the staging buffer (for tests: GPUs without import take this way)
};

/// Bytes of a mapping that fill a mip level of an image.
struct ImageCopy {
    const gpu::Image* image = nullptr;
    std::uint32_t mip = 0;
    std::uint64_t offset = 0, size = 0; ///< in the mapping
};

/// Bytes of a mapping that fill part of a buffer.
struct BufferCopy {
    const gpu::Buffer* buffer = nullptr;
    std::uint64_t buffer_offset = 0, offset = 0, size = 0;
};

/// Copies of one mapping. `mapping` begins at a page and stays mapped until upload() returns.
struct UploadJob {
    std::span<const std::byte> mapping;
    std::vector<ImageCopy> images;
    std::vector<BufferCopy> buffers;
};

/// Fills images (left ready to be sampled by fragment shaders) and buffers, and waits until they are resident. Where
/// the device allows it nothing is copied on the way: images are filled straight from the mapping, mapped buffers by
/// memcpy.
void upload(const gpu::Device& device, std::span<const UploadJob> jobs, UploadPath path);

} // namespace atrium
