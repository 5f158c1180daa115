#pragma once
// The scene's geometry, and lists of draw commands sorted by material class.

#include "renderer/graph/graph.hpp"
#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <span>

namespace atrium {

/// Neighbouring draw commands that share pipeline and cull mode.
struct DrawRange {
    MaterialClass cls = MaterialClass::opaque;
    bool two_sided = false;
    std::uint32_t first = 0, count = 0;
};

/// The commands of a frame: one VkDrawIndexedIndirectCommand per task, in draw order.
struct DrawList {
    graph::Buf commands;
    std::span<const DrawRange> ranges;
    std::uint32_t count = 0;
    graph::Buf indices; ///< used instead of the scene's index buffer if single triangles were culled
};

/// The scene's vertex and index buffers.
struct Geometry {
    const gpu::Buffer* vertices = nullptr;
    const gpu::Buffer* indices = nullptr;
    bool materials_diverge = true; ///< fragments of several draws may share a subgroup: on all but CPU devices
};

} // namespace atrium
