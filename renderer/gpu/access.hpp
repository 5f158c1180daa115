#pragma once
// The few ways in which a pass may use an image or a buffer, and what each means to Vulkan. The frame graph derives
// every barrier from this table and from nothing else.

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace atrium::gpu {

enum class Access : std::uint8_t {
    none,               ///< never used yet; contents undefined
    color_write,        ///< colour attachment, written whole or blended (read and write)
    resolve_write,      ///< single-sampled image that a multisampled colour attachment is resolved into
    depth_write,        ///< depth attachment with test and write
    depth_read,         ///< depth attachment, test only; may be sampled in the same pass
    sampled_fragment,   ///< sampled image or read-only storage buffer in fragment shaders
    sampled_compute,    ///< the same in compute shaders
    sampled_vertex,     ///< the same in vertex, tessellation and geometry shaders
    storage_read,       ///< storage image or buffer in compute shaders: only read
    storage_write,      ///< storage image or buffer in compute shaders: written, perhaps read too
    storage_fragment,   ///< the same in fragment shaders
    address_fragment,   ///< buffer that fragment shaders read through its device address, without a binding
    address_compute,    ///< the same in compute shaders
    address_vertex,     ///< the same in vertex, tessellation and geometry shaders
    address_write,      ///< the same in compute shaders: written, perhaps read too
    acceleration_input, ///< buffer that an acceleration structure build reads: vertices, instances, another structure
    acceleration_build, ///< buffer of an acceleration structure that is built or updated, or the build's scratch
    acceleration_fragment, ///< buffer of an acceleration structure that fragment shaders trace rays in
    acceleration_compute,  ///< the same in compute shaders
    indirect_read,         ///< indirect commands or their count
    index_read,
    vertex_read,
    transfer_read,
    transfer_write,
    host_read, ///< after the GPU has finished, by the CPU
    present,   ///< handed to the window system
    count
};

struct AccessInfo {
    const char* name;
    VkPipelineStageFlags2 stages;
    VkAccessFlags2 access; ///< all of them
    VkAccessFlags2 writes; ///< the writing ones among them; 0 for a read
    VkImageLayout layout;  ///< for images; UNDEFINED where an access makes sense for buffers only
};

[[nodiscard]] const AccessInfo& info(Access access);
[[nodiscard]] inline bool is_write(Access access)
{
    return info(access).writes != 0;
}

} // namespace atrium::gpu
