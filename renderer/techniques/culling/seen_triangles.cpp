#include "renderer/techniques/culling/seen_triangles.hpp"

#include "shaders/shared/culling.h"

#include <algorithm>

namespace atrium {
namespace {

gpu::Buffer make_buffer(const gpu::Device& device, const char* name, std::uint64_t words, VkBufferUsageFlags usage)
{
    return {device, name, std::max(words, std::uint64_t{1}) * sizeof(std::uint32_t),
            usage | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
            gpu::MemoryUse::device};
}

} // namespace

SeenTriangles::SeenTriangles(const gpu::Device& device, const DrawTasks& tasks)
    : frames_(make_buffer(device, "seen.frames", tasks.index_count / 3, 0)), frame_(shared::first_remembered_frame)
{
    constexpr std::uint64_t command_words = sizeof(shared::DrawCommand) / sizeof(std::uint32_t);
    for (List& list : lists_) {
        list.commands =
            make_buffer(device, "seen.commands", tasks.count * command_words, VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT);
        list.occluder_commands = make_buffer(device, "seen.occluder_commands", tasks.count * command_words,
                                             VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT);
        list.indices = make_buffer(device, "seen.indices", tasks.index_count, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    }
}

SeenInFrame SeenTriangles::begin(graph::Graph& g, const DrawTasks& tasks)
{
    using gpu::Access;
    const bool first = frame_ == shared::first_remembered_frame;
    const auto import = [&](const char* name, const gpu::Buffer& buffer, Access used) {
        return g.import(name, buffer, first ? Access::none : used);
    };
    const List& before = lists_[frame_ % 2];
    const List& now = lists_[(frame_ + 1) % 2];
    SeenInFrame out;
    out.frame = frame_++;
    out.before.commands = import("seen.before.commands", before.commands, Access::indirect_read);
    out.before.indices = import("seen.before.indices", before.indices, Access::index_read);
    out.before.ranges = tasks.ranges;
    out.before.count = tasks.count;
    out.occluders = out.before;
    out.occluders.commands = import("seen.before.occluder_commands", before.occluder_commands, Access::indirect_read);
    out.commands = import("seen.commands", now.commands, Access::indirect_read);
    out.occluder_commands = import("seen.occluder_commands", now.occluder_commands, Access::indirect_read);
    out.indices = import("seen.indices", now.indices, Access::index_read);
    out.frames = import("seen.frames", frames_, Access::storage_write);
    g.keep(out.commands, Access::indirect_read);
    g.keep(out.occluder_commands, Access::indirect_read);
    g.keep(out.indices, Access::index_read);
    g.keep(out.frames, Access::storage_write);
    if (first) { // nothing was seen
        for (const graph::Buf& buffer : {out.before.commands, out.occluders.commands, out.before.indices, out.frames})
            g.transfer("seen.forget").writes(buffer).record([=](graph::Cmd& cmd) { cmd.fill(buffer, 0); });
    }
    return out;
}

} // namespace atrium
