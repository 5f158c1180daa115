#include "renderer/graph/runner.hpp"

#include "renderer/gpu/result.hpp"
#include "renderer/graph/bindings.hpp"
#include "renderer/graph/persistents.hpp"
#include "renderer/graph/transients.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace atrium::graph {
namespace {

double ms_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

Runner::Runner(const gpu::Device& device, gpu::Descriptors& descriptors, gpu::Pipelines& pipelines)
    : device_(device), descriptors_(descriptors), pipelines_(pipelines), slot_(device),
      transients_(std::make_unique<Transients>(device)), persistents_(std::make_unique<Persistents>(device))
{}

Runner::~Runner() = default;

GraphDesc Runner::describe(const Graph& graph)
{
    GraphDesc out;
    for (std::size_t i = 0; i < graph.resources_.size(); ++i) {
        const Graph::Resource& r = graph.resources_[i];
        ResourceDesc desc;
        desc.name = r.name;
        desc.is_image = r.is_image;
        desc.mips = r.desc.mips;
        desc.layers = r.desc.layers;
        desc.samples = r.desc.samples;
        desc.transient = !r.is_imported() && !r.is_persistent();
        desc.keep = r.keep;
        desc.initial = r.initial;
        if (r.is_persistent()) desc.initial_parts = parts_before(graph, static_cast<ResourceIndex>(i));
        transients_->requirements(static_cast<ResourceIndex>(i), desc);
        out.resources.push_back(std::move(desc));
    }
    for (const Pass& pass : graph.passes_) out.passes.push_back({pass.name, pass.uses, pass.side_effect});
    return out;
}

namespace {

/// A target of the pass, for its size and sample count.
Tex any_target(const Pass& pass)
{
    return pass.colors.empty() ? pass.depth.value().texture : pass.colors.front().texture;
}

std::uint32_t samples_of(const Graph& graph, const Pass& pass)
{
    return pass.kind == PassKind::raster ? graph.desc(any_target(pass)).samples : 1;
}

std::vector<std::string> shaders_of(const gpu::GraphicsPipelineDesc& desc)
{
    return desc.shaders();
}

std::vector<std::string> shaders_of(const gpu::ComputePipelineDesc& desc)
{
    return {desc.shader};
}

} // namespace

void Runner::lay_out_bindings(const Graph& graph, Pass& pass)
{
    const auto is_image = [&](ResourceIndex r) { return graph.resources_[r].is_image; };
    pass.bound = bind_uses(pass, is_image);
    std::vector<gpu::PassBinding> bindings;
    for (const BoundUse& b : pass.bound) bindings.push_back(b.at);
    pass.layout = descriptors_.pass_layout(bindings);

    bool known = true; // a pipeline with this layout was checked when it was made
    std::vector<ShaderBindings> shaders;
    const auto look_at = [&](auto& descs) {
        for (auto& desc : descs) {
            desc.pass_layout = pass.layout;
            known = known && pipelines_.exists(desc);
        }
    };
    look_at(pass.graphics);
    look_at(pass.compute);
    if (known) return;
    const auto list = [&](const auto& descs) {
        for (const auto& desc : descs) {
            for (const std::string& shader : shaders_of(desc))
                shaders.push_back({shader, pipelines_.pass_bindings(shader)});
        }
    };
    list(pass.graphics);
    list(pass.compute);
    check_bindings(pass, pass.bound, shaders, [&](ResourceIndex r) { return graph.resources_[r].name; });
}

void Runner::prepare_pipelines(Graph& graph)
{
    std::vector<gpu::GraphicsPipelineDesc> graphics;
    std::vector<gpu::ComputePipelineDesc> compute;
    for (const PlannedPass& planned : plan_.passes) {
        Pass& pass = graph.passes_[planned.pass];
        for (gpu::GraphicsPipelineDesc& desc : pass.graphics) {
            desc.colors.clear();
            for (const Attachment& color : pass.colors) desc.colors.push_back(graph.desc(color.texture).format);
            desc.samples = samples_of(graph, pass);
            desc.depth = pass.depth ? graph.desc(pass.depth->texture).format : gpu::Format::none;
        }
        lay_out_bindings(graph, pass);
        graphics.insert(graphics.end(), pass.graphics.begin(), pass.graphics.end());
        compute.insert(compute.end(), pass.compute.begin(), pass.compute.end());
    }
    pipelines_.prepare(graphics, compute);
}

void Runner::forget()
{
    persistents_->forget();
}

std::vector<PartState> Runner::parts_before(const Graph& graph, ResourceIndex r) const
{
    const Graph::Resource& resource = graph.resources_[r];
    const PersistentUse& use = graph.persistents_[resource.persistent];
    const Persistents::Entry* entry = persistents_->find(use.hash, use.key);
    const bool fresh = use.history && !resource.is_history;
    std::vector<PartState> parts;
    if (entry && entry->matches(use)) parts = entry->slots[fresh ? 1 - entry->current : entry->current].parts;
    if (parts.empty()) parts.resize(resource.is_image ? std::size_t{resource.desc.mips} * resource.desc.layers : 1);
    if (fresh) {
        for (PartState& part : parts) part.defined = false;
    }
    return parts;
}

void Runner::create_persistents(const Graph& graph)
{
    persistents_->create(graph.persistents_);
    slots_.assign(graph.resources_.size(), nullptr);
    for (std::size_t r = 0; r < slots_.size(); ++r) {
        const Graph::Resource& resource = graph.resources_[r];
        if (!resource.is_persistent()) continue;
        slots_[r] = &persistents_->slot(graph.persistents_[resource.persistent], resource.is_history);
    }
}

/// Called after submission: updates the state of persistent resources.
void Runner::commit(const Graph& graph)
{
    if (!graph.store_) return;
    std::vector<bool> written(graph.resources_.size(), false);
    for (const PlannedPass& planned : plan_.passes) {
        for (const Use& use : described_.passes[planned.pass].uses) {
            if (gpu::is_write(use.access)) written[use.resource] = true;
        }
    }
    persistents_->commit(graph.persistents_, graph.view_, plan_, written);
}

namespace {

/// Sets the running graph. At the end of the scope, also when an exception is thrown, there is none, and its uploads
/// have been used.
struct Running {
    Running(const Graph*& now, const Graph& graph, Uploads& used) : running(now), uploads(used) { running = &graph; }
    ~Running()
    {
        running = nullptr;
        uploads.begin();
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    const Graph*& running;
    Uploads& uploads;
};

} // namespace

RunStats Runner::run(Graph& graph, gpu::TimerMode mode, const gpu::SubmitSync& sync)
{
    if (!graph.persistents_.empty() && graph.epoch_ != persistents_->epoch())
        throw std::logic_error("other graphs have run since this graph with persistent resources was declared");
    const Running running{graph_, graph, slot_.uploads};
    RunStats stats;
    const auto start = std::chrono::steady_clock::now();
    transients_->create(graph.resources_.size(), [&](ResourceIndex i) {
        const Graph::Resource& r = graph.resources_[i];
        return TransientDesc{r.name, r.is_image, r.is_imported() || r.is_persistent(),
                             r.desc, r.bytes,    usage_of(i, graph.passes_)};
    });
    described_ = describe(graph);
    plan_ = make_plan(described_, graph.finals_);
    transients_->place(plan_);
    const auto planned = std::chrono::steady_clock::now();
    prepare_pipelines(graph);
    const double compile_ms = ms_since(planned);

    create_persistents(graph);
    slot_.timers.reset();
    device_.submit([&](VkCommandBuffer cmd) { record(cmd, graph, mode, stats); }, sync);
    commit(graph);
    stats.cpu_ms = ms_since(start) - compile_ms;
    device_.wait();
    stats.wall_ms = ms_since(start) - compile_ms;
    persistents_->release_unused();

    const std::vector<gpu::PassTime> times = slot_.timers.read();
    for (std::size_t i = 0; i < times.size(); ++i) {
        stats.passes[i].gpu_ms = times[i].ms;
        stats.passes[i].gpu_start_ms = times[i].start_ms;
    }
    return stats;
}

void Runner::record(VkCommandBuffer commands, Graph& graph, gpu::TimerMode mode, RunStats& stats)
{
    descriptors_.begin_frame();
    descriptors_.bind_frame(commands);
    for (const PlannedPass& planned : plan_.passes) {
        const Pass& pass = graph.passes_[planned.pass];
        device_.begin_label(commands, pass.name);
        issue(commands, planned.barriers);
        slot_.timers.begin(commands, pass.name, mode);
        bind_resources(commands, pass);
        Cmd cmd(*this, commands);
        cmd.pass_ = &pass;
        if (pass.kind == PassKind::raster) begin_rendering(commands, pass, planned.unstored);
        if (pass.record) pass.record(cmd);
        if (pass.kind == PassKind::raster) vkCmdEndRendering(commands);
        slot_.timers.end(commands, mode);
        device_.end_label(commands);
        stats.passes.push_back({pass.name, cmd.draws_, cmd.pipeline_binds_, 0});
    }
    issue(commands, plan_.final_barriers);
}

void Runner::bind_resources(VkCommandBuffer commands, const Pass& pass)
{
    std::vector<gpu::PassDescriptor> descriptors;
    for (const BoundUse& bound : pass.bound) {
        const Use& use = pass.uses[bound.use];
        gpu::PassDescriptor& d = descriptors.emplace_back();
        d.at = bound.at;
        if (!described_.resources[use.resource].is_image) {
            d.buffer = buffer_of(use.resource);
            continue;
        }
        const SubresourceRange& r = use.range;
        d.view = image(use.resource).view({r.first_mip, r.mips, r.first_layer, r.layers, use.as_array});
        d.layout = gpu::info(use.access).layout;
    }
    const auto point =
        pass.kind == PassKind::compute ? VK_PIPELINE_BIND_POINT_COMPUTE : VK_PIPELINE_BIND_POINT_GRAPHICS;
    descriptors_.bind_pass(commands, point, pass.layout, descriptors);
}

namespace {

bool is_integer(gpu::Format format)
{
    return format == gpu::Format::r32_uint || format == gpu::Format::rg32_uint;
}

} // namespace

void Runner::issue(VkCommandBuffer cmd, const std::vector<Barrier>& barriers) const
{
    issue_barriers(
        cmd, barriers, [this](ResourceIndex r) { return image_of(r); },
        [this](ResourceIndex r) { return buffer_of(r); },
        [this](ResourceIndex r) { return gpu::is_depth(graph_->resources_[r].desc.format); });
}

void Runner::begin_rendering(VkCommandBuffer cmd, const Pass& pass, std::uint64_t unstored) const
{
    const auto attachment = [&](const Attachment& a, VkImageLayout layout, bool is_depth) {
        VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
        info.imageView = image(a.texture.index).view({a.mip, 1, a.layer, 1});
        info.imageLayout = layout;
        info.loadOp = a.load == Load::clear     ? VK_ATTACHMENT_LOAD_OP_CLEAR
                      : a.load == Load::discard ? VK_ATTACHMENT_LOAD_OP_DONT_CARE
                                                : VK_ATTACHMENT_LOAD_OP_LOAD;
        const bool stored = a.use >= 64 || ((unstored >> a.use) & 1) == 0;
        info.storeOp = stored ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
        if (a.resolve) {
            info.resolveMode = is_integer(graph_->desc(a.texture).format) ? VK_RESOLVE_MODE_SAMPLE_ZERO_BIT
                                                                          : VK_RESOLVE_MODE_AVERAGE_BIT;
            info.resolveImageView = image(a.resolve.index).view();
            info.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        }
        if (is_depth) {
            info.clearValue.depthStencil = {a.clear.x, 0};
        } else {
            for (int i = 0; i < 4; ++i) info.clearValue.color.float32[i] = a.clear[i];
        }
        return info;
    };
    std::vector<VkRenderingAttachmentInfo> colors;
    for (const Attachment& a : pass.colors)
        colors.push_back(attachment(a, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, false));
    VkRenderingAttachmentInfo depth{};
    if (pass.depth) {
        depth = attachment(*pass.depth, gpu::info(pass.depth_writes ? Access::depth_write : Access::depth_read).layout,
                           true);
        // A depth image that is only tested keeps its contents without being stored again.
        if (!pass.depth_writes) depth.storeOp = VK_ATTACHMENT_STORE_OP_NONE;
    }
    const uvec2 size = graph_->size(any_target(pass), pass.colors.empty() ? 0 : pass.colors.front().mip);

    VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
    info.renderArea.extent = {size.x, size.y};
    info.layerCount = 1;
    info.colorAttachmentCount = static_cast<std::uint32_t>(colors.size());
    info.pColorAttachments = colors.data();
    info.pDepthAttachment = pass.depth ? &depth : nullptr;
    vkCmdBeginRendering(cmd, &info);
    set_viewport(cmd, uvec2(0), size);
    vkCmdSetCullMode(cmd, VK_CULL_MODE_NONE);
}

void set_viewport(VkCommandBuffer cmd, uvec2 origin, uvec2 size)
{
    const vec2 at(origin), extent(size);
    const VkViewport viewport{at.x, at.y + extent.y, extent.x, -extent.y, 0, 1};
    const VkRect2D scissor{{static_cast<std::int32_t>(origin.x), static_cast<std::int32_t>(origin.y)},
                           {size.x, size.y}};
    vkCmdSetViewport(cmd, 0, 1, &viewport);
    vkCmdSetScissor(cmd, 0, 1, &scissor);
}

const gpu::Image& Runner::image(ResourceIndex r) const
{
    if (slots_[r]) return slots_[r]->image;
    const gpu::Image* imported = graph_->resources_[r].imported_image;
    return imported ? *imported : transients_->image(r);
}

VkImage Runner::image_of(ResourceIndex r) const
{
    return graph_->resources_[r].is_image ? image(r).handle() : VK_NULL_HANDLE;
}

VkBuffer Runner::buffer_of(ResourceIndex r) const
{
    const Graph::Resource& resource = graph_->resources_[r];
    if (resource.is_image) return VK_NULL_HANDLE;
    if (slots_[r]) return slots_[r]->buffer.handle();
    return resource.imported ? resource.imported->handle() : transients_->buffer(r).handle();
}

void issue_barriers(VkCommandBuffer cmd, const std::vector<Barrier>& barriers,
                    const std::function<VkImage(ResourceIndex)>& image_of,
                    const std::function<VkBuffer(ResourceIndex)>& buffer_of,
                    const std::function<bool(ResourceIndex)>& is_depth)
{
    if (barriers.empty()) return;
    std::vector<VkImageMemoryBarrier2> images;
    std::vector<VkBufferMemoryBarrier2> buffers;
    std::vector<VkMemoryBarrier2> memory;
    for (const Barrier& b : barriers) {
        if (const VkImage image = image_of(b.resource)) {
            VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
            barrier.srcStageMask = b.src_stages;
            barrier.srcAccessMask = b.src_access;
            barrier.dstStageMask = b.dst_stages;
            barrier.dstAccessMask = b.dst_access;
            barrier.oldLayout = b.old_layout;
            barrier.newLayout = b.new_layout;
            barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
            barrier.image = image;
            barrier.subresourceRange = {static_cast<VkImageAspectFlags>(is_depth(b.resource)
                                                                            ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                                            : VK_IMAGE_ASPECT_COLOR_BIT),
                                        b.range.first_mip, b.range.mips, b.range.first_layer, b.range.layers};
            images.push_back(barrier);
            if (b.takes_memory) { // An image barrier says nothing of what was written through the memory's last owner.
                VkMemoryBarrier2 alias{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
                alias.srcStageMask = b.src_stages;
                alias.srcAccessMask = b.src_access;
                alias.dstStageMask = b.dst_stages;
                alias.dstAccessMask = b.dst_access;
                memory.push_back(alias);
            }
        } else {
            VkBufferMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2};
            barrier.srcStageMask = b.src_stages;
            barrier.srcAccessMask = b.src_access;
            barrier.dstStageMask = b.dst_stages;
            barrier.dstAccessMask = b.dst_access;
            barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
            barrier.buffer = buffer_of(b.resource);
            barrier.size = VK_WHOLE_SIZE;
            buffers.push_back(barrier);
        }
    }
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = static_cast<std::uint32_t>(memory.size());
    dependency.pMemoryBarriers = memory.data();
    dependency.imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size());
    dependency.pImageMemoryBarriers = images.data();
    dependency.bufferMemoryBarrierCount = static_cast<std::uint32_t>(buffers.size());
    dependency.pBufferMemoryBarriers = buffers.data();
    vkCmdPipelineBarrier2(cmd, &dependency);
}

} // namespace atrium::graph
