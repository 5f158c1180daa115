#include "renderer/scene_upload.hpp"

#include "renderer/core/log.hpp"
#include "renderer/gpu/host_import.hpp"
#include "renderer/graph/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>

namespace atrium {
namespace {

constexpr std::uint64_t staging_bytes = 32ull << 20;

/// The transitions around all copies, planned like any frame: one pass that writes every image, each then sampled.
class Transitions {
public:
    explicit Transitions(std::span<const UploadJob> jobs)
    {
        graph::GraphDesc desc;
        graph::PassDesc pass{"upload", {}, true};
        std::vector<graph::FinalUse> finals;
        for (const UploadJob& job : jobs) {
            for (const ImageCopy& copy : job.images) {
                if (copy.mip != 0) continue;
                const auto index = static_cast<graph::ResourceIndex>(images_.size());
                const std::uint32_t mips = copy.image->desc().mips;
                images_.push_back(copy.image->handle());
                graph::ResourceDesc resource;
                resource.name = fmt::format("texture {}", index);
                resource.mips = mips;
                resource.transient = false;
                desc.resources.push_back(resource);
                pass.uses.push_back({index, graph::Access::transfer_write, {0, mips, 0, 1}, true});
                finals.push_back({index, graph::Access::sampled_fragment});
            }
        }
        desc.passes.push_back(std::move(pass));
        plan_ = graph::make_plan(desc, finals);
    }
    void before(VkCommandBuffer cmd) const { issue(cmd, plan_.passes.front().barriers); }
    void after(VkCommandBuffer cmd) const { issue(cmd, plan_.final_barriers); }

private:
    void issue(VkCommandBuffer cmd, const std::vector<graph::Barrier>& barriers) const
    {
        graph::issue_barriers(
            cmd, barriers, [this](graph::ResourceIndex r) { return images_[r]; },
            [](graph::ResourceIndex) { return VkBuffer{VK_NULL_HANDLE}; }, [](graph::ResourceIndex) { return false; });
    }
    std::vector<VkImage> images_;
    graph::Plan plan_;
};

void copy_rows(VkCommandBuffer cmd, VkBuffer from, std::uint64_t offset, const ImageCopy& copy, std::uint32_t first_row,
               std::uint32_t rows)
{
    const gpu::ImageDesc& desc = copy.image->desc();
    VkBufferImageCopy region{};
    region.bufferOffset = offset;
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, copy.mip, 0, 1};
    region.imageOffset = {0, static_cast<std::int32_t>(first_row), 0};
    region.imageExtent = {std::max(desc.width >> copy.mip, 1u), rows, 1};
    vkCmdCopyBufferToImage(cmd, from, copy.image->handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

std::uint32_t height_of(const ImageCopy& copy)
{
    return std::max(copy.image->desc().height >> copy.mip, 1u);
}

/// Buffers that the CPU sees are written by it, while the device copies images.
void write_mapped_buffers(std::span<const UploadJob> jobs)
{
    for (const UploadJob& job : jobs) {
        for (const BufferCopy& copy : job.buffers) {
            if (copy.buffer->mapped().empty() || copy.size == 0) continue;
            std::memcpy(copy.buffer->mapped().data() + copy.buffer_offset, job.mapping.data() + copy.offset, copy.size);
            copy.buffer->flush();
        }
    }
}

void upload_imported(const gpu::Device& device, std::span<const UploadJob> jobs,
                     std::span<const gpu::HostImport> imports)
{
    const Transitions transitions(jobs);
    device.submit([&](VkCommandBuffer cmd) {
        transitions.before(cmd);
        for (std::size_t j = 0; j < jobs.size(); ++j) {
            const VkBuffer source = imports[j].buffer();
            for (const ImageCopy& copy : jobs[j].images) copy_rows(cmd, source, copy.offset, copy, 0, height_of(copy));
            for (const BufferCopy& copy : jobs[j].buffers) {
                if (!copy.buffer->mapped().empty() || copy.size == 0) continue;
                const VkBufferCopy region{copy.offset, copy.buffer_offset, copy.size};
                vkCmdCopyBuffer(cmd, source, copy.buffer->handle(), 1, &region);
            }
        }
        transitions.after(cmd);
    });
    write_mapped_buffers(jobs);
    device.wait();
}

/// A small buffer, filled and emptied again and again: it stays in the cache, and no file's worth of memory is touched.
class StagingRing {
public:
    explicit StagingRing(const gpu::Device& device)
        : device_(device),
          buffer_(device, "staging", staging_bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, gpu::MemoryUse::upload)
    {}
    /// Appends bytes and the command that reads them; runs what has gathered first when there is no room.
    void add(std::span<const std::byte> bytes, std::function<void(VkCommandBuffer, VkBuffer, std::uint64_t)> command)
    {
        used_ = (used_ + 15) / 16 * 16;
        if (used_ + bytes.size() > staging_bytes) run();
        std::memcpy(buffer_.mapped().data() + used_, bytes.data(), bytes.size());
        commands_.emplace_back(used_, std::move(command));
        used_ += bytes.size();
    }
    void run()
    {
        buffer_.flush();
        device_.run([&](VkCommandBuffer cmd) {
            for (const auto& [offset, command] : commands_) command(cmd, buffer_.handle(), offset);
        });
        commands_.clear();
        used_ = 0;
    }

private:
    const gpu::Device& device_;
    gpu::Buffer buffer_;
    std::uint64_t used_ = 0;
    std::vector<std::pair<std::uint64_t, std::function<void(VkCommandBuffer, VkBuffer, std::uint64_t)>>> commands_;
};

void stage_image(StagingRing& ring, const UploadJob& job, const ImageCopy& copy)
{
    const bool blocks = copy.image->desc().format >= gpu::Format::bc1_srgb;
    const std::uint32_t step = blocks ? 4 : 1, height = height_of(copy), row_count = (height + step - 1) / step;
    const std::uint64_t row_bytes = copy.size / row_count;
    const auto rows_at_once = static_cast<std::uint32_t>(std::max<std::uint64_t>(staging_bytes / 2 / row_bytes, 1));
    for (std::uint32_t row = 0; row < row_count; row += rows_at_once) {
        const std::uint32_t rows = std::min(rows_at_once, row_count - row);
        ring.add(job.mapping.subspan(copy.offset + row * row_bytes, rows * row_bytes),
                 [=](VkCommandBuffer cmd, VkBuffer from, std::uint64_t offset) {
                     copy_rows(cmd, from, offset, copy, row * step, std::min(rows * step, height - row * step));
                 });
    }
}

void stage_buffer(StagingRing& ring, const UploadJob& job, const BufferCopy& copy)
{
    for (std::uint64_t done = 0; done < copy.size;) {
        const std::uint64_t piece = std::min(staging_bytes / 2, copy.size - done);
        ring.add(job.mapping.subspan(copy.offset + done, piece),
                 [=](VkCommandBuffer cmd, VkBuffer from, std::uint64_t offset) {
                     const VkBufferCopy region{offset, copy.buffer_offset + done, piece};
                     vkCmdCopyBuffer(cmd, from, copy.buffer->handle(), 1, &region);
                 });
        done += piece;
    }
}

void upload_staged(const gpu::Device& device, std::span<const UploadJob> jobs)
{
    const Transitions transitions(jobs);
    device.run([&](VkCommandBuffer cmd) { transitions.before(cmd); });
    StagingRing ring(device);
    for (const UploadJob& job : jobs) {
        for (const ImageCopy& copy : job.images) stage_image(ring, job, copy);
        for (const BufferCopy& copy : job.buffers) stage_buffer(ring, job, copy);
    }
    ring.run();
    device.run([&](VkCommandBuffer cmd) { transitions.after(cmd); });
}

} // namespace

void upload(const gpu::Device& device, std::span<const UploadJob> jobs, UploadPath path)
{
    if (path == UploadPath::automatic && device.import_alignment() > 0) {
        std::vector<gpu::HostImport> imports;
        for (const UploadJob& job : jobs) {
            std::optional<gpu::HostImport> import = gpu::HostImport::create(device, job.mapping);
            if (!import) break; // Some drivers refuse mappings of files.
            imports.push_back(std::move(*import));
        }
        if (imports.size() == jobs.size()) {
            upload_imported(device, jobs, imports);
            return;
        }
        log_verbose("the device does not import the mapped bake; loading through a staging buffer");
    }
    upload_staged(device, jobs);
}

} // namespace atrium
