#include "renderer/techniques/culling/seen_triangles.hpp"

#include "shaders/shared/culling.h"

#include <algorithm>
#include <string>

namespace atrium {
namespace {

struct Pair {
    graph::Buf before, now;
};

graph::Buf add_zeros(graph::Graph& g, const std::string& name, graph::Buf buffer)
{
    g.transfer(name + ".forget").writes(buffer).record([=](graph::Cmd& cmd) { cmd.fill(buffer, 0); });
    return buffer;
}

/// The buffer that the last frame wrote, also if that was long ago; zeros (nothing visible) if there is none.
Pair declare_pair(graph::Graph& g, const std::string& name, std::uint64_t bytes)
{
    const graph::Buf now = g.persistent(name, bytes);
    const graph::Buf before = g.history(now).before;
    return {before ? before : add_zeros(g, name, g.buffer(name + ".before", bytes)), now};
}

} // namespace

SeenInFrame declare_seen(graph::Graph& g, const DrawTasks& tasks)
{
    const std::uint64_t command_bytes = std::max(tasks.count, 1u) * sizeof(shared::DrawCommand);
    const auto bytes_of = [](std::uint64_t words) { return std::max(words, std::uint64_t{1}) * sizeof(std::uint32_t); };
    const Pair commands = declare_pair(g, "seen.commands", command_bytes);
    const Pair occluders = declare_pair(g, "seen.occluder_commands", command_bytes);
    const Pair indices = declare_pair(g, "seen.indices", bytes_of(tasks.index_count));
    SeenInFrame out;
    out.before = {commands.before, tasks.ranges, tasks.count, indices.before};
    out.occluders = {occluders.before, tasks.ranges, tasks.count, indices.before};
    out.commands = commands.now;
    out.occluder_commands = occluders.now;
    out.indices = indices.now;
    out.frames = g.persistent("seen.frames", bytes_of(tasks.index_count / 3));
    const auto last = g.noted<std::uint32_t>(out.frames);
    out.frame = last ? *last + 1 : shared::first_remembered_frame;
    if (!last) add_zeros(g, "seen.frames", out.frames);
    g.note(out.frames, out.frame);
    return out;
}

} // namespace atrium
