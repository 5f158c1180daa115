#pragma once
// What one frame saw, for the next one to begin with.

#include "renderer/techniques/culling/culling.hpp"

#include <array>

namespace atrium {

/// The triangles that a frame saw, kept on the device. Of one scene: a new one needs a new memory. Source: Haar &
/// Aaltonen 2015, "GPU-Driven Rendering Pipelines", who remember clusters.
class SeenTriangles {
public:
    SeenTriangles(const gpu::Device& device, const DrawTasks& tasks);

    /// Brings the memory into a frame's graph, which must run before the next call.
    [[nodiscard]] SeenInFrame begin(graph::Graph& g, const DrawTasks& tasks);

private:
    struct List {
        gpu::Buffer commands, occluder_commands, indices;
    };
    std::array<List, 2> lists_; ///< of this frame and of the one before, in turn
    gpu::Buffer frames_;        ///< of each triangle, the number of the frame that last saw it
    std::uint32_t frame_;
};

} // namespace atrium
