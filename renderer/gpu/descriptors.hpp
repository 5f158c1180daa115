#pragma once
// Everything a shader can reach, in three sets that all pipelines share:
//   set 0  materials: the bindless array of textures, and the samplers          (shaders/lib/textures.glsl)
//   set 1  the frame's constants and the scene's tables                         (shaders/lib/frame.glsl, scene.glsl)
//   set 2  what the pass declared: image i at binding i, storage buffer j at binding max_pass_images + j, storage image
//          k at binding max_pass_images + max_pass_buffers + k
// Only textures are bindless: what changes during a frame has bindings of its own, so that validation can follow it.

#include "renderer/gpu/resources.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace atrium::gpu {

using TextureSlot = std::uint32_t;

/// Slots of the samplers; same order as in shaders/lib/textures.glsl.
enum class SamplerSlot : std::uint32_t { material, material_clamp, linear_clamp, nearest_clamp, shadow, count };

/// The buffers of set 1, by binding.
enum class FrameBinding : std::uint32_t { constants, materials, records, clusters, draw_tasks, draw_order, vertices, indices, ltc, count };

struct PassImage {
    VkImageView view = VK_NULL_HANDLE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

class Descriptors {
public:
    static constexpr std::uint32_t texture_capacity = 8192; ///< devices with descriptor indexing guarantee 500,000
    static constexpr std::uint32_t max_pass_images = 12, max_pass_buffers = 7, max_passes = 4096;
    static constexpr std::uint32_t max_pass_storage_images = 4;
    static constexpr std::uint32_t push_bytes = 128; ///< what every device has

    explicit Descriptors(const Device& device);
    ~Descriptors();
    Descriptors(const Descriptors&) = delete;
    Descriptors& operator=(const Descriptors&) = delete;

    /// Throws Error(environment) when the table is full.
    [[nodiscard]] TextureSlot add_texture(const Image& image);
    void remove_texture(TextureSlot slot) { free_textures_.push_back(slot); }

    /// The samplers that read materials; anisotropy 1 is trilinear. Between frames only, as are the next two.
    void set_material_filter(float anisotropy, float mip_bias);
    void set_frame_buffer(FrameBinding binding, const Buffer& buffer);
    /// Forgets the sets of the last frame's passes.
    void begin_frame();

    [[nodiscard]] VkPipelineLayout pipeline_layout() const { return pipeline_layout_; }
    void bind_frame(VkCommandBuffer cmd) const; ///< sets 0 and 1, for graphics and compute
    void bind_pass(VkCommandBuffer cmd, VkPipelineBindPoint point, std::span<const PassImage> images,
                   std::span<const VkBuffer> buffers,
                   std::span<const PassImage> storage_images); ///< set 2

private:
    void write_sampler(SamplerSlot slot, VkSampler sampler); ///< takes ownership

    const Device& device_;
    std::array<VkDescriptorSetLayout, 3> layouts_{};
    VkDescriptorPool table_pool_ = VK_NULL_HANDLE, pass_pool_ = VK_NULL_HANDLE;
    VkDescriptorSet textures_ = VK_NULL_HANDLE, frame_ = VK_NULL_HANDLE;
    VkPipelineLayout pipeline_layout_ = VK_NULL_HANDLE;
    std::array<VkSampler, static_cast<std::size_t>(SamplerSlot::count)> samplers_{};
    float anisotropy_ = -1, mip_bias_ = 0;
    std::vector<TextureSlot> free_textures_;
    std::uint32_t used_textures_ = 0;
};

} // namespace atrium::gpu
