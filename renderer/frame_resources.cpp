#include "renderer/frame_resources.hpp"

#include <algorithm>

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

FrameResources::FrameResources(const gpu::Device& device, gpu::Descriptors& descriptors)
    : readbacks(device), device_(device), descriptors_(descriptors),
      constants_(device, "frame constants", sizeof(shared::FrameConstants), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                 gpu::MemoryUse::upload)
{
    descriptors.set_frame_buffer(gpu::FrameBinding::constants, constants_);
}

gpu::Buffer FrameResources::make_table(gpu::FrameBinding binding, const char* name, std::uint64_t bytes)
{
    constexpr std::uint64_t smallest = 256; // a buffer of a scene without items
    gpu::Buffer table(device_, name, std::max(bytes, smallest), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                      gpu::MemoryUse::upload);
    descriptors_.set_frame_buffer(binding, table);
    return table;
}

void FrameResources::set_scene(const GpuScene* scene)
{
    for (gpu::Buffer* table : {&draw_order_, &materials_, &records_}) *table = {};
    if (!scene) return;
    draw_order_ = make_table(gpu::FrameBinding::draw_order, "draw order", scene->tasks().count * sizeof(std::uint32_t));
    materials_ = make_table(gpu::FrameBinding::materials, "materials", scene->packed_materials().size_bytes());
    records_ = make_table(gpu::FrameBinding::records, "records", scene->records().size_bytes());
    scene_version_ = 0;
}

void FrameResources::write(const shared::FrameConstants& values)
{
    constants_.write(std::span(&values, 1));
}

void FrameResources::write(const GpuScene& scene)
{
    scene.write_order(std::span(reinterpret_cast<std::uint32_t*>(draw_order_.mapped().data()), scene.tasks().count));
    draw_order_.flush();
    if (scene_version_ == scene.version()) return;
    scene_version_ = scene.version();
    materials_.write(scene.packed_materials());
    records_.write(scene.records());
}

} // namespace atrium
