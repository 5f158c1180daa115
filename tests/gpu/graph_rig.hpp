#pragma once
// Graphs on the device with a runner of their own, their images as numbers.

#include "tests/rig/device_rig.hpp"

#include <cstring>
#include <vector>

namespace atrium::rig {

class GraphRig {
public:
    graph::Runner runner{device().device, device().descriptors, device().pipelines};

    [[nodiscard]] graph::Graph begin(const graph::FrameInfo& frame = {}) { return {runner, frame}; }

    /// An RGBA32F image with these values, four for each texel.
    [[nodiscard]] graph::Tex upload(graph::Graph& g, uvec2 size, const std::vector<float>& values)
    {
        const graph::Buf from = g.upload("uploaded", values);
        const graph::Tex to = g.texture("picture", {gpu::Format::rgba32_float, size.x, size.y});
        g.transfer("upload").reads(from).writes(to).record([=](graph::Cmd& cmd) { cmd.copy(from, to); });
        return to;
    }
    /// An image of one colour.
    [[nodiscard]] graph::Tex plain(graph::Graph& g, uvec2 size, float value)
    {
        const graph::Tex to = g.texture("picture", {gpu::Format::rgba32_float, size.x, size.y});
        g.raster("fill").writes(to, graph::Load::clear, vec4(value));
        return to;
    }
    /// Runs the graph and returns a mip of an RGBA32F image, four values for each texel.
    [[nodiscard]] std::vector<float> run(graph::Graph& g, graph::Tex image, std::uint32_t mip = 0)
    {
        const uvec2 size = g.size(image, mip);
        std::vector<float> out(std::size_t{4} * size.x * size.y);
        const gpu::Buffer target(device().device, "numbers", out.size() * sizeof(float),
                                 VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryUse::readback);
        const graph::Buf to = g.import("read back", target);
        g.keep(to, gpu::Access::host_read);
        g.transfer("read back").reads_mip(image, mip).writes(to).record([=](graph::Cmd& cmd) {
            cmd.copy(image, to, mip);
        });
        static_cast<void>(runner.run(g));
        target.invalidate();
        std::memcpy(out.data(), target.mapped().data(), out.size() * sizeof(float));
        return out;
    }
};

} // namespace atrium::rig
