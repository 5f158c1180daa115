#include "renderer/gpu/descriptors.hpp"

#include "renderer/core/error.hpp"
#include "renderer/gpu/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace atrium::gpu {
namespace {

constexpr std::uint32_t sampler_count = static_cast<std::uint32_t>(SamplerSlot::count);
constexpr std::uint32_t frame_bindings = static_cast<std::uint32_t>(FrameBinding::count);
constexpr VkDescriptorBindingFlags partial = VK_DESCRIPTOR_BINDING_PARTIALLY_BOUND_BIT;
constexpr VkDescriptorBindingFlags live = partial | VK_DESCRIPTOR_BINDING_UPDATE_AFTER_BIND_BIT;

VkDescriptorSetLayout create_layout(VkDevice device, std::span<const VkDescriptorSetLayoutBinding> bindings,
                                    VkDescriptorBindingFlags flag)
{
    const std::vector<VkDescriptorBindingFlags> flags(bindings.size(), flag);
    VkDescriptorSetLayoutBindingFlagsCreateInfo with_flags{
        VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_BINDING_FLAGS_CREATE_INFO};
    with_flags.bindingCount = static_cast<std::uint32_t>(flags.size());
    with_flags.pBindingFlags = flags.data();
    VkDescriptorSetLayoutCreateInfo create{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    create.pNext = &with_flags;
    if (flag & VK_DESCRIPTOR_BINDING_UPDATE_AFTER_BIND_BIT) {
        create.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_UPDATE_AFTER_BIND_POOL_BIT;
    }
    create.bindingCount = static_cast<std::uint32_t>(bindings.size());
    create.pBindings = bindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    check(vkCreateDescriptorSetLayout(device, &create, nullptr, &layout), "create a descriptor set layout");
    return layout;
}

VkDescriptorSetLayout texture_layout(VkDevice device)
{
    const std::array<VkDescriptorSetLayoutBinding, 2> bindings{{
        {0, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, Descriptors::texture_capacity, VK_SHADER_STAGE_ALL, nullptr},
        {1, VK_DESCRIPTOR_TYPE_SAMPLER, sampler_count, VK_SHADER_STAGE_ALL, nullptr},
    }};
    return create_layout(device, bindings, live);
}

VkDescriptorSetLayout frame_layout(VkDevice device)
{
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < frame_bindings; ++i) {
        const auto type = i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        bindings.push_back({i, type, 1, VK_SHADER_STAGE_ALL, nullptr});
    }
    return create_layout(device, bindings, partial);
}

VkDescriptorSetLayout pass_set_layout(VkDevice device, std::span<const PassBinding> bindings)
{
    std::vector<VkDescriptorSetLayoutBinding> all;
    for (const PassBinding& b : bindings) all.push_back({b.binding, b.type, 1, VK_SHADER_STAGE_ALL, nullptr});
    return create_layout(device, all, 0);
}

/// For the sets of some hundred passes; more pools are created if a frame needs them.
constexpr std::uint32_t sets_per_pool = 256;
constexpr std::array<VkDescriptorPoolSize, 3> pass_pool_sizes{{
    {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, sets_per_pool * 8},
    {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, sets_per_pool * 8},
    {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, sets_per_pool * 2},
}};

VkDescriptorPool create_pool(VkDevice device, std::uint32_t sets, std::span<const VkDescriptorPoolSize> sizes,
                             VkDescriptorPoolCreateFlags flags)
{
    VkDescriptorPoolCreateInfo create{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    create.flags = flags;
    create.maxSets = sets;
    create.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    create.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    check(vkCreateDescriptorPool(device, &create, nullptr, &pool), "create a descriptor pool");
    return pool;
}

/// Null if the pool is exhausted.
VkDescriptorSet try_allocate_set(VkDevice device, VkDescriptorPool pool, const VkDescriptorSetLayout& layout)
{
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &layout;
    VkDescriptorSet set = VK_NULL_HANDLE;
    const VkResult result = vkAllocateDescriptorSets(device, &allocate, &set);
    if (result == VK_ERROR_OUT_OF_POOL_MEMORY || result == VK_ERROR_FRAGMENTED_POOL) return VK_NULL_HANDLE;
    check(result, "allocate a descriptor set");
    return set;
}

/// Compares with reversed depth: 1 where the reference is at least as near as what is stored. Where the device filters
/// depth, the mean of four comparisons.
VkSampler create_shadow_sampler(const Device& device)
{
    VkFormatProperties depth{};
    vkGetPhysicalDeviceFormatProperties(device.physical(), vk(Format::depth32), &depth);
    const bool filters = (depth.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
    VkSamplerCreateInfo create{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    create.magFilter = create.minFilter = filters ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    create.addressModeU = create.addressModeV = create.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    create.compareEnable = VK_TRUE;
    create.compareOp = VK_COMPARE_OP_GREATER_OR_EQUAL;
    VkSampler sampler = VK_NULL_HANDLE;
    check(vkCreateSampler(device.handle(), &create, nullptr, &sampler), "create the shadow sampler");
    return sampler;
}

VkSampler create_sampler(VkDevice device, VkFilter filter, VkSamplerAddressMode address, float anisotropy,
                         float mip_bias)
{
    VkSamplerCreateInfo create{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    create.magFilter = create.minFilter = filter;
    create.mipmapMode = filter == VK_FILTER_LINEAR ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    create.addressModeU = create.addressModeV = create.addressModeW = address;
    create.mipLodBias = mip_bias;
    create.anisotropyEnable = anisotropy > 1;
    create.maxAnisotropy = std::max(anisotropy, 1.0f);
    create.maxLod = VK_LOD_CLAMP_NONE;
    VkSampler sampler = VK_NULL_HANDLE;
    check(vkCreateSampler(device, &create, nullptr, &sampler), "create a sampler");
    return sampler;
}

VkWriteDescriptorSet write_of(VkDescriptorSet set, std::uint32_t binding, std::uint32_t element, VkDescriptorType type)
{
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = binding;
    write.dstArrayElement = element;
    write.descriptorCount = 1;
    write.descriptorType = type;
    return write;
}

} // namespace

Descriptors::Descriptors(const Device& device)
    : device_(device), layouts_{texture_layout(device.handle()), frame_layout(device.handle())}
{
    const std::array<VkDescriptorPoolSize, 4> table_sizes{{
        {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, texture_capacity},
        {VK_DESCRIPTOR_TYPE_SAMPLER, sampler_count},
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, frame_bindings - 1},
    }};
    table_pool_ = create_pool(device.handle(), 2, table_sizes, VK_DESCRIPTOR_POOL_CREATE_UPDATE_AFTER_BIND_BIT);
    textures_ = try_allocate_set(device.handle(), table_pool_, layouts_[0]);
    frame_ = try_allocate_set(device.handle(), table_pool_, layouts_[1]);
    static_cast<void>(pass_layout({}));

    constexpr auto clamp = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    write_sampler(SamplerSlot::linear_clamp, create_sampler(device.handle(), VK_FILTER_LINEAR, clamp, 1, 0));
    write_sampler(SamplerSlot::nearest_clamp, create_sampler(device.handle(), VK_FILTER_NEAREST, clamp, 1, 0));
    write_sampler(SamplerSlot::shadow, create_shadow_sampler(device));
    set_material_filter(1, 0);
}

Descriptors::~Descriptors()
{
    for (VkSampler sampler : samplers_) vkDestroySampler(device_.handle(), sampler, nullptr);
    for (const Set2& layout : pass_layouts_) {
        vkDestroyPipelineLayout(device_.handle(), layout.pipeline, nullptr);
        vkDestroyDescriptorSetLayout(device_.handle(), layout.set, nullptr);
    }
    for (VkDescriptorPool pool : pass_pools_) vkDestroyDescriptorPool(device_.handle(), pool, nullptr);
    vkDestroyDescriptorPool(device_.handle(), table_pool_, nullptr);
    for (VkDescriptorSetLayout layout : layouts_) vkDestroyDescriptorSetLayout(device_.handle(), layout, nullptr);
}

TextureSlot Descriptors::add_texture(const Image& image)
{
    TextureSlot slot = used_textures_;
    if (!free_textures_.empty()) {
        slot = free_textures_.back();
        free_textures_.pop_back();
    } else if (used_textures_++ == texture_capacity) {
        throw Error(ExitCode::environment, "the scene has too many textures", "",
                    fmt::format("the table holds {}", texture_capacity), "bake a scene with fewer");
    }
    const VkDescriptorImageInfo info{VK_NULL_HANDLE, image.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    VkWriteDescriptorSet write = write_of(textures_, 0, slot, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE);
    write.pImageInfo = &info;
    vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
    return slot;
}

void Descriptors::write_sampler(SamplerSlot slot, VkSampler sampler)
{
    VkSampler& owned = samplers_[static_cast<std::size_t>(slot)];
    if (owned) vkDestroySampler(device_.handle(), owned, nullptr);
    owned = sampler;
    const VkDescriptorImageInfo info{sampler, VK_NULL_HANDLE, VK_IMAGE_LAYOUT_UNDEFINED};
    VkWriteDescriptorSet write = write_of(textures_, 1, static_cast<std::uint32_t>(slot), VK_DESCRIPTOR_TYPE_SAMPLER);
    write.pImageInfo = &info;
    vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
}

void Descriptors::set_material_filter(float anisotropy, float mip_bias)
{
    anisotropy = std::clamp(anisotropy, 1.0f, device_.max_anisotropy());
    if (anisotropy == anisotropy_ && mip_bias == mip_bias_) return;
    anisotropy_ = anisotropy;
    mip_bias_ = mip_bias;
    constexpr auto repeat = VK_SAMPLER_ADDRESS_MODE_REPEAT, clamp = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    write_sampler(SamplerSlot::material,
                  create_sampler(device_.handle(), VK_FILTER_LINEAR, repeat, anisotropy, mip_bias));
    write_sampler(SamplerSlot::material_clamp,
                  create_sampler(device_.handle(), VK_FILTER_LINEAR, clamp, anisotropy, mip_bias));
}

void Descriptors::set_frame_buffer(FrameBinding binding, const Buffer& buffer)
{
    const VkDescriptorBufferInfo info{buffer.handle(), 0, VK_WHOLE_SIZE};
    const auto type =
        binding == FrameBinding::constants ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    VkWriteDescriptorSet write = write_of(frame_, static_cast<std::uint32_t>(binding), 0, type);
    write.pBufferInfo = &info;
    vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
}

void Descriptors::begin_frame()
{
    for (VkDescriptorPool pool : pass_pools_) vkResetDescriptorPool(device_.handle(), pool, 0);
    pass_pool_ = 0;
}

PassLayout Descriptors::pass_layout(std::span<const PassBinding> bindings)
{
    std::vector<PassBinding> key(bindings.begin(), bindings.end());
    if (const auto known = pass_layout_numbers_.find(key); known != pass_layout_numbers_.end()) return known->second;
    Set2& made = pass_layouts_.emplace_back();
    made.set = pass_set_layout(device_.handle(), bindings);

    const std::array sets{layouts_[0], layouts_[1], made.set};
    const VkPushConstantRange push{VK_SHADER_STAGE_ALL, 0, push_bytes};
    VkPipelineLayoutCreateInfo create{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    create.setLayoutCount = static_cast<std::uint32_t>(sets.size());
    create.pSetLayouts = sets.data();
    create.pushConstantRangeCount = 1;
    create.pPushConstantRanges = &push;
    check(vkCreatePipelineLayout(device_.handle(), &create, nullptr, &made.pipeline), "create a pipeline layout");
    const auto number = static_cast<PassLayout>(pass_layouts_.size() - 1);
    pass_layout_numbers_.emplace(std::move(key), number);
    return number;
}

void Descriptors::bind_frame(VkCommandBuffer cmd) const
{
    const std::array sets{textures_, frame_};
    for (const auto point : {VK_PIPELINE_BIND_POINT_GRAPHICS, VK_PIPELINE_BIND_POINT_COMPUTE}) {
        vkCmdBindDescriptorSets(cmd, point, pipeline_layout(), 0, static_cast<std::uint32_t>(sets.size()), sets.data(),
                                0, nullptr);
    }
}

VkDescriptorSet Descriptors::allocate_pass_set(VkDescriptorSetLayout layout)
{
    for (; pass_pool_ < pass_pools_.size(); ++pass_pool_) {
        if (const VkDescriptorSet set = try_allocate_set(device_.handle(), pass_pools_[pass_pool_], layout)) return set;
    }
    pass_pools_.push_back(create_pool(device_.handle(), sets_per_pool, pass_pool_sizes, 0));
    const VkDescriptorSet set = try_allocate_set(device_.handle(), pass_pools_.back(), layout);
    if (!set) throw std::logic_error("a pass binds more descriptors than a pool holds");
    return set;
}

void Descriptors::bind_pass(VkCommandBuffer cmd, VkPipelineBindPoint point, PassLayout layout,
                            std::span<const PassDescriptor> descriptors)
{
    if (descriptors.empty()) return;
    const VkDescriptorSet set = allocate_pass_set(pass_layouts_[layout].set);
    std::vector<VkDescriptorImageInfo> images(descriptors.size());
    std::vector<VkDescriptorBufferInfo> buffers(descriptors.size());
    std::vector<VkWriteDescriptorSet> writes;
    for (std::size_t i = 0; i < descriptors.size(); ++i) {
        const PassDescriptor& d = descriptors[i];
        writes.push_back(write_of(set, d.at.binding, 0, d.at.type));
        images[i] = {VK_NULL_HANDLE, d.view, d.layout};
        buffers[i] = {d.buffer, 0, VK_WHOLE_SIZE};
        if (d.buffer)
            writes.back().pBufferInfo = &buffers[i];
        else
            writes.back().pImageInfo = &images[i];
    }
    vkUpdateDescriptorSets(device_.handle(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
    vkCmdBindDescriptorSets(cmd, point, pipeline_layout(layout), 2, 1, &set, 0, nullptr);
}

} // namespace atrium::gpu
