#pragma once
// A frame's lights, as the device and whatever outlives a frame need them; reckoned once a frame.

#include "renderer/scene/light.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace atrium {

/// Tells a light from all others, in this frame and in those around it.
using LightKey = std::uint64_t;

/// Lights are named by the user's index in here, unless a name says otherwise. The lights themselves belong to whoever
/// made the set.
struct LightSet {
    std::span<const Light> lights;

    /// Where each stands in the GPU's table: those without area first, rectangles behind.
    std::vector<std::uint32_t> places;
    std::uint32_t delta_count = 0; ///< suns, spots and points

    /// Those that cast shadows, in order: the n-th has layer n of visibility.
    std::vector<std::uint32_t> shadowed;

    /// By these, shadow maps and history of a light are found again in the next frame, whatever its index is then. A
    /// light that has an `id` goes by that: a window gives one to each, so that it stays the same light when it is
    /// renamed, and a new one is another even if it gets the name of a removed one. Any other goes by its name, which
    /// is unique, and so stays the same when others come or go, in one run of the program and from run to run.
    /// "light0", "light1", … are names like any other: they belong to an index when they are given, but a light keeps
    /// its own when one before it goes. A light without any name goes by the name that name_lights() would give it.
    std::vector<LightKey> keys;

    [[nodiscard]] std::optional<std::uint32_t> shadow_layer(std::size_t light) const;
};

/// @param most_shadowed  as many of the lights that are to cast shadows do, the first ones
[[nodiscard]] LightSet make_light_set(std::span<const Light> lights, std::size_t most_shadowed);

} // namespace atrium
