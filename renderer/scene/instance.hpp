#pragma once
// Copies of a bake in the world.

#include "renderer/core/math.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace atrium {

/// A copy of a bake, or of one of its meshes, somewhere in the world. Its index is the AOV `instance`.
struct Instance {
    std::size_t bake = 0;
    std::optional<std::uint32_t> mesh; ///< empty: all meshes
    mat4 world_from_object{1};
};

/// Where an instance was in the previous frame, for motion vectors.
struct PreviousInstance {
    std::uint32_t instance = 0;
    mat4 world_from_object{1};
};

} // namespace atrium
