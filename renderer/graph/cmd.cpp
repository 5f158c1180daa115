// Recording: the thin layer between a pass and vkCmd….

#include "renderer/graph/graph.hpp"
#include "renderer/graph/runner.hpp"
#include "renderer/graph/transients.hpp"

#include <algorithm>

namespace atrium::graph {
namespace {

/// Limits that every device supports: work groups along an axis of a dispatch, and commands of an indirect draw.
constexpr std::uint32_t most_at_once = 65535;

} // namespace

void Cmd::push_bytes(const void* data, std::size_t size)
{
    vkCmdPushConstants(commands_, runner_.descriptors_.pipeline_layout(), VK_SHADER_STAGE_ALL, 0,
                       static_cast<std::uint32_t>(size), data);
}

void Cmd::bind(std::size_t pipeline)
{
    const bool compute = pass_->kind == PassKind::compute;
    vkCmdBindPipeline(commands_, compute ? VK_PIPELINE_BIND_POINT_COMPUTE : VK_PIPELINE_BIND_POINT_GRAPHICS,
                      compute ? runner_.pipelines_.get(pass_->compute.at(pipeline))
                              : runner_.pipelines_.get(pass_->graphics.at(pipeline)));
    ++pipeline_binds_;
}

void Cmd::cull(CullMode mode)
{
    vkCmdSetCullMode(commands_, mode == CullMode::back ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE);
}

void Cmd::viewport(uvec2 origin, uvec2 size)
{
    set_viewport(commands_, origin, size);
}

void Cmd::scissor(uvec2 origin, uvec2 size)
{
    const VkRect2D rect{{static_cast<std::int32_t>(origin.x), static_cast<std::int32_t>(origin.y)}, {size.x, size.y}};
    vkCmdSetScissor(commands_, 0, 1, &rect);
}

void Cmd::clear_depth(uvec2 origin, uvec2 size, float depth)
{
    VkClearAttachment clear{};
    clear.aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT;
    clear.clearValue.depthStencil = {depth, 0};
    const VkClearRect rect{
        {{static_cast<std::int32_t>(origin.x), static_cast<std::int32_t>(origin.y)}, {size.x, size.y}}, 0, 1};
    vkCmdClearAttachments(commands_, 1, &clear, 1, &rect);
}

void Cmd::draw_fullscreen()
{
    vkCmdDraw(commands_, 3, 1, 0, 0);
    ++draws_;
}

namespace {

void bind_buffers(VkCommandBuffer commands, VkBuffer vertices, VkBuffer indices)
{
    const VkDeviceSize zero = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &zero);
    vkCmdBindIndexBuffer(commands, indices, 0, VK_INDEX_TYPE_UINT32);
}

} // namespace

void Cmd::bind_geometry(const gpu::Buffer& vertices, const gpu::Buffer& indices)
{
    bind_buffers(commands_, vertices.handle(), indices.handle());
}

void Cmd::bind_geometry(const gpu::Buffer& vertices, Buf indices)
{
    bind_buffers(commands_, vertices.handle(), runner_.buffer_of(indices.index));
}

void Cmd::bind_indices(Buf indices)
{
    vkCmdBindIndexBuffer(commands_, runner_.buffer_of(indices.index), 0, VK_INDEX_TYPE_UINT32);
}

void Cmd::draw_indexed(std::uint32_t first_index, std::uint32_t index_count, std::uint32_t first_instance)
{
    vkCmdDrawIndexed(commands_, index_count, 1, first_index, 0, first_instance);
    ++draws_;
}

void Cmd::draw_indexed_indirect(Buf commands, std::uint32_t first, std::uint32_t count)
{
    constexpr std::uint32_t stride = sizeof(VkDrawIndexedIndirectCommand);
    for (std::uint32_t done = 0; done < count; done += most_at_once) {
        vkCmdDrawIndexedIndirect(commands_, runner_.buffer_of(commands.index), VkDeviceSize{first + done} * stride,
                                 std::min(count - done, most_at_once), stride);
        ++draws_;
    }
}

void Cmd::dispatch(std::uint32_t items, std::uint32_t group_size)
{
    const std::uint32_t groups = items / group_size + (items % group_size != 0 ? 1 : 0);
    const std::uint32_t rows = std::max((groups + most_at_once - 1) / most_at_once, 1u);
    vkCmdDispatch(commands_, (groups + rows - 1) / rows, rows, 1);
}

void Cmd::dispatch_over(Tex image, std::uint32_t mip)
{
    constexpr std::uint32_t side = 8;
    const uvec2 groups = (runner_.graph_->size(image, mip) + side - 1u) / side;
    vkCmdDispatch(commands_, groups.x, groups.y, 1);
}

namespace {

VkImageSubresourceLayers first_layer(const TexDesc& desc, std::uint32_t mip = 0)
{
    return {static_cast<VkImageAspectFlags>(gpu::is_depth(desc.format) ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                                       : VK_IMAGE_ASPECT_COLOR_BIT),
            mip, 0, 1};
}

} // namespace

void Cmd::copy(Tex from, Buf to, std::uint32_t mip)
{
    const uvec2 size = runner_.graph_->size(from, mip);
    VkBufferImageCopy region{};
    region.imageSubresource = first_layer(runner_.graph_->desc(from), mip);
    region.imageExtent = {size.x, size.y, 1};
    vkCmdCopyImageToBuffer(commands_, runner_.image_of(from.index), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           runner_.buffer_of(to.index), 1, &region);
}

void Cmd::copy(Buf from, Tex to)
{
    const uvec2 size = runner_.graph_->size(to);
    VkBufferImageCopy region{};
    region.imageSubresource = first_layer(runner_.graph_->desc(to));
    region.imageExtent = {size.x, size.y, 1};
    vkCmdCopyBufferToImage(commands_, runner_.buffer_of(from.index), runner_.image_of(to.index),
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

void Cmd::copy(Tex from, Tex to)
{
    const TexDesc& desc = runner_.graph_->desc(from);
    VkImageCopy region{};
    region.srcSubresource = first_layer(desc);
    region.dstSubresource = first_layer(runner_.graph_->desc(to));
    region.extent = {desc.width, desc.height, 1};
    vkCmdCopyImage(commands_, runner_.image_of(from.index), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                   runner_.image_of(to.index), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

void Cmd::copy(Buf from, Buf to, std::uint64_t bytes)
{
    const VkBufferCopy region{0, 0, bytes};
    vkCmdCopyBuffer(commands_, runner_.buffer_of(from.index), runner_.buffer_of(to.index), 1, &region);
}

void Cmd::fill(Buf buffer, std::uint32_t word)
{
    vkCmdFillBuffer(commands_, runner_.buffer_of(buffer.index), 0, VK_WHOLE_SIZE, word);
}

} // namespace atrium::graph
