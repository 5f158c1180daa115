#pragma once
// Everything a shader can reach, in three sets:
//   set 0  materials: the bindless array of textures, and the samplers          (shaders/lib/textures.glsl)
//   set 1  the frame's constants and the scene's tables                         (shaders/lib/frame.glsl, scene.glsl)
//   set 2  what the pass declared                                               (shaders/lib/pass.glsl)
// All pipelines share the layouts of sets 0 and 1; that of set 2 follows from what the pass's shaders bind.
// Only textures are bindless: what changes during a frame has bindings of its own, so that validation can follow it.

#include "renderer/gpu/resources.hpp"

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace atrium::gpu {

using TextureSlot = std::uint32_t;

/// Slots of the samplers; same order as in shaders/lib/textures.glsl.
enum class SamplerSlot : std::uint32_t { material, material_clamp, linear_clamp, nearest_clamp, shadow, count };

/// The buffers of set 1, by binding.
enum class FrameBinding : std::uint32_t {
    constants,
    materials,
    records,
    clusters,
    draw_tasks,
    draw_order,
    vertices,
    indices,
    ltc,
    count
};

/// A binding of set 2 and the kind of descriptor there.
struct PassBinding {
    std::uint32_t binding = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
    auto operator<=>(const PassBinding&) const = default;
};
/// Number of a layout of set 2, from Descriptors::pass_layout(). Number 0 has no bindings.
using PassLayout = std::uint32_t;

/// The descriptor for a binding of set 2: an image view and its layout, or a buffer.
struct PassDescriptor {
    PassBinding at;
    VkImageView view = VK_NULL_HANDLE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkBuffer buffer = VK_NULL_HANDLE;
};

class Descriptors {
public:
    static constexpr std::uint32_t texture_capacity = 8192; ///< devices with descriptor indexing guarantee 500,000
    static constexpr std::uint32_t max_passes = 4096;
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

    /// The layout of set 2 with these bindings, each once and in ascending order.
    [[nodiscard]] PassLayout pass_layout(std::span<const PassBinding> bindings);
    [[nodiscard]] VkPipelineLayout pipeline_layout(PassLayout layout = 0) const
    {
        return pass_layouts_[layout].pipeline;
    }
    void bind_frame(VkCommandBuffer cmd) const; ///< sets 0 and 1, for graphics and compute
    /// Set 2. `descriptors` fill all bindings of `layout`, in its order.
    void bind_pass(VkCommandBuffer cmd, VkPipelineBindPoint point, PassLayout layout,
                   std::span<const PassDescriptor> descriptors);

private:
    struct Set2 {
        VkDescriptorSetLayout set = VK_NULL_HANDLE;
        VkPipelineLayout pipeline = VK_NULL_HANDLE;
    };
    [[nodiscard]] VkDescriptorSet allocate_pass_set(VkDescriptorSetLayout layout);
    void write_sampler(SamplerSlot slot, VkSampler sampler); ///< takes ownership

    const Device& device_;
    std::array<VkDescriptorSetLayout, 2> layouts_{}; ///< of sets 0 and 1
    std::vector<Set2> pass_layouts_;
    std::map<std::vector<PassBinding>, PassLayout> pass_layout_numbers_;
    VkDescriptorPool table_pool_ = VK_NULL_HANDLE;
    std::vector<VkDescriptorPool> pass_pools_; ///< used one after the other, and reset in each frame
    std::size_t pass_pool_ = 0;                ///< the one in use
    VkDescriptorSet textures_ = VK_NULL_HANDLE, frame_ = VK_NULL_HANDLE;
    std::array<VkSampler, static_cast<std::size_t>(SamplerSlot::count)> samplers_{};
    float anisotropy_ = -1, mip_bias_ = 0;
    std::vector<TextureSlot> free_textures_;
    std::uint32_t used_textures_ = 0;
};

} // namespace atrium::gpu
