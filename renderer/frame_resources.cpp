#include "renderer/frame_resources.hpp"

#include <cstring>

namespace atrium {
namespace {

std::uint64_t bytes_of(const graph::TexDesc& desc)
{
    return std::uint64_t{desc.width} * desc.height * gpu::bytes_per_texel(desc.format);
}

} // namespace

const gpu::Buffer& Readbacks::next(std::uint64_t bytes)
{
    if (used_ == buffers_.size()) buffers_.emplace_back();
    auto& slot = buffers_[used_++];
    if (!slot || slot->size() != bytes) {
        slot = std::make_unique<gpu::Buffer>(device_, "readback", bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                             gpu::MemoryUse::readback);
    }
    return *slot;
}

const gpu::Buffer& Readbacks::add(graph::Graph& g, graph::Tex texture, const std::string& name)
{
    const gpu::Buffer& buffer = next(bytes_of(g.desc(texture)));
    const graph::Buf target = g.import("readback." + name, buffer);
    g.keep(target, gpu::Access::host_read);
    g.transfer("readback." + name).reads(texture).writes(target).record([=](graph::Cmd& cmd) {
        cmd.copy(texture, target);
    });
    return buffer;
}

const gpu::Buffer& Readbacks::add(graph::Graph& g, graph::Buf from, std::uint64_t bytes, const std::string& name)
{
    const gpu::Buffer& buffer = next(bytes);
    const graph::Buf target = g.import("readback." + name, buffer);
    g.keep(target, gpu::Access::host_read);
    g.transfer("readback." + name).reads(from).writes(target).record([=](graph::Cmd& cmd) {
        cmd.copy(from, target, bytes);
    });
    return buffer;
}

std::span<const std::byte> bytes_in(const gpu::Buffer& buffer)
{
    buffer.invalidate();
    return buffer.mapped();
}

FrameResources::FrameResources(const gpu::Device& device)
    : constants(device, "frame constants", sizeof(shared::FrameConstants), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                gpu::MemoryUse::upload),
      readbacks(device)
{}

void FrameResources::write(const shared::FrameConstants& values)
{
    std::memcpy(constants.mapped().data(), &values, sizeof(values));
    constants.flush();
}

} // namespace atrium
