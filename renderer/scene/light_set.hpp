#pragma once
// The lights of a frame with their order on the device and their keys for persistent resources; computed once a frame.

#include "renderer/scene/light.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace atrium {

/// Identifies a light, in this frame and from frame to frame.
using LightKey = std::uint64_t;

/// A light index is the user's index, unless stated otherwise. The lights themselves belong to the caller of
/// make_light_set().
struct LightSet {
    std::span<const Light> lights;

    /// By light: its place in the GPU's table. Lights without area come first, then rectangles.
    std::vector<std::uint32_t> places;
    std::uint32_t delta_count = 0; ///< suns, spots and points

    /// Lights that cast shadows, in order: the n-th has layer n of the visibility image.
    std::vector<std::uint32_t> shadowed;

    /// By light: identifies its shadow maps and history in the next frame, also if its index has changed. The key is
    /// made from `Light::id` if that is set. The window gives each light an id: it stays the same when the light is
    /// renamed, and a new light with the name of a removed one has another. Otherwise the key is made from the name,
    /// which is unique, so it does not change when other lights are added or removed, nor from run to run. "light0",
    /// "light1", … are ordinary names: they come from the index when they are given, and are kept when an earlier light
    /// is removed. A light without a name has the key of the name that name_lights() would give it.
    std::vector<LightKey> keys;

    [[nodiscard]] std::optional<std::uint32_t> shadow_layer(std::size_t light) const;
};

/// @param most_shadowed  how many lights may cast shadows: the first ones of those with shadows on
[[nodiscard]] LightSet make_light_set(std::span<const Light> lights, std::size_t most_shadowed);

} // namespace atrium
