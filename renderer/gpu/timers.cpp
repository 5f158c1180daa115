#include "renderer/gpu/timers.hpp"

#include "renderer/gpu/result.hpp"

#include <stdexcept>

namespace atrium::gpu {

Timers::Timers(const Device& device, std::uint32_t capacity) : device_(device), capacity_(2 * capacity)
{
    VkQueryPoolCreateInfo create{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    create.queryType = VK_QUERY_TYPE_TIMESTAMP;
    create.queryCount = capacity_;
    check(vkCreateQueryPool(device.handle(), &create, nullptr, &pool_), "create timers");
}

Timers::~Timers()
{
    vkDestroyQueryPool(device_.handle(), pool_, nullptr);
}

void Timers::reset()
{
    vkResetQueryPool(device_.handle(), pool_, 0, capacity_);
    used_ = 0;
    names_.clear();
}

namespace {

/// Not a dependency of the frame's (those are the graph's): it only keeps passes from overlapping while measured.
void wait_for_everything(VkCommandBuffer cmd)
{
    VkMemoryBarrier2 everything{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    everything.srcStageMask = everything.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    everything.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    everything.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &everything;
    vkCmdPipelineBarrier2(cmd, &dependency);
}

} // namespace

void Timers::stamp(VkCommandBuffer cmd, TimerMode mode)
{
    if (used_ == capacity_) throw std::logic_error("more passes than timers");
    if (mode == TimerMode::serialized) wait_for_everything(cmd);
    vkCmdWriteTimestamp2(cmd, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_, used_++);
    // lavapipe puts a timestamp among the commands of the targets last drawn to, and reads the clock only when those
    // are flushed: after a dispatch, or after draws to the same targets, that follow it.
    if (mode == TimerMode::serialized) wait_for_everything(cmd);
}

void Timers::begin(VkCommandBuffer cmd, std::string name, TimerMode mode)
{
    names_.push_back(std::move(name));
    stamp(cmd, mode);
}

void Timers::end(VkCommandBuffer cmd, TimerMode mode)
{
    stamp(cmd, mode);
}

std::vector<PassTime> Timers::read() const
{
    std::vector<PassTime> times;
    if (used_ == 0) return times;
    std::vector<std::uint64_t> ticks(used_);
    check(vkGetQueryPoolResults(device_.handle(), pool_, 0, used_, ticks.size() * sizeof(ticks[0]), ticks.data(),
                                sizeof(ticks[0]), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "read the timers");
    const auto ms_between = [&](std::uint64_t from, std::uint64_t to) {
        return static_cast<double>(to - from) * device_.timestamp_period() * 1e-6;
    };
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const std::uint64_t start = ticks[2 * i], end = ticks[2 * i + 1];
        times.push_back({names_[i], ms_between(start, end), ms_between(ticks[0], start)});
    }
    return times;
}

} // namespace atrium::gpu
