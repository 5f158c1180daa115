#include "renderer/gpu/access.hpp"

#include <array>
#include <cstddef>

namespace atrium::gpu {
namespace {

constexpr VkPipelineStageFlags2 depth_stages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr VkPipelineStageFlags2 vertex_stages = VK_PIPELINE_STAGE_2_PRE_RASTERIZATION_SHADERS_BIT;
constexpr VkAccessFlags2 shader_read = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
constexpr VkAccessFlags2 color_write_bit = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 depth_write_bit = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 depth_read_bit = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
constexpr VkAccessFlags2 storage_read_bit = VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
constexpr VkAccessFlags2 storage_write_bit = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
constexpr VkPipelineStageFlags2 build_stage = VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR;
constexpr VkAccessFlags2 acceleration_read_bit = VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR;
constexpr VkAccessFlags2 acceleration_write_bit = VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR;

constexpr std::array<AccessInfo, static_cast<std::size_t>(Access::count)> table{{
    {"none", 0, 0, 0, VK_IMAGE_LAYOUT_UNDEFINED},
    {"color_write", VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
     color_write_bit | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT, color_write_bit,
     VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL},
    {"resolve_write", VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, color_write_bit, color_write_bit,
     VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL},
    {"depth_write", depth_stages, depth_read_bit | depth_write_bit, depth_write_bit,
     VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL},
    {"depth_read", depth_stages | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
     depth_read_bit | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, 0, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL},
    {"sampled_fragment", VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, shader_read, 0,
     VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
    {"sampled_compute", VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, shader_read, 0,
     VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
    {"sampled_vertex", vertex_stages, shader_read, 0, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
    {"storage_read", VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, storage_read_bit, 0, VK_IMAGE_LAYOUT_GENERAL},
    {"storage_write", VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, shader_read | storage_write_bit, storage_write_bit,
     VK_IMAGE_LAYOUT_GENERAL},
    {"storage_fragment", VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, shader_read | storage_write_bit, storage_write_bit,
     VK_IMAGE_LAYOUT_GENERAL},
    {"address_fragment", VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, storage_read_bit, 0, VK_IMAGE_LAYOUT_UNDEFINED},
    {"address_compute", VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, storage_read_bit, 0, VK_IMAGE_LAYOUT_UNDEFINED},
    {"address_vertex", vertex_stages, storage_read_bit, 0, VK_IMAGE_LAYOUT_UNDEFINED},
    {"address_write", VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, storage_read_bit | storage_write_bit, storage_write_bit,
     VK_IMAGE_LAYOUT_UNDEFINED},
    {"acceleration_input", build_stage, VK_ACCESS_2_SHADER_READ_BIT | acceleration_read_bit, 0,
     VK_IMAGE_LAYOUT_UNDEFINED},
    {"acceleration_build", build_stage, acceleration_read_bit | acceleration_write_bit, acceleration_write_bit,
     VK_IMAGE_LAYOUT_UNDEFINED},
    {"acceleration_fragment", VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, acceleration_read_bit, 0,
     VK_IMAGE_LAYOUT_UNDEFINED},
    {"acceleration_compute", VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, acceleration_read_bit, 0,
     VK_IMAGE_LAYOUT_UNDEFINED},
    {"indirect_read", VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, 0,
     VK_IMAGE_LAYOUT_UNDEFINED},
    {"index_read", VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT, VK_ACCESS_2_INDEX_READ_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED},
    {"vertex_read", VK_PIPELINE_STAGE_2_VERTEX_ATTRIBUTE_INPUT_BIT, VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT, 0,
     VK_IMAGE_LAYOUT_UNDEFINED},
    {"transfer_read", VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, 0,
     VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL},
    {"transfer_write", VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
     VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL},
    {"host_read", VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT, 0, VK_IMAGE_LAYOUT_GENERAL},
    {"present", VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE, 0, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR},
}};

} // namespace

const AccessInfo& info(Access access)
{
    return table[static_cast<std::size_t>(access)];
}

} // namespace atrium::gpu
