#pragma once
// Polygons to triangles.

#include "renderer/core/math.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace atrium {

/// More corners than this are refused: the search is quadratic.
inline constexpr std::size_t max_polygon_corners = 32768;

struct EarClipping {
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices into the polygon, wound as it is
    bool simple = true; ///< false: no ear was left, since the polygon crosses itself; some triangles are a guess
};

/// Cuts a polygon of n >= 3 corners into n - 2 triangles by clipping ears of its projection along its mean normal
/// (Newell). Works for concave polygons; work is bounded for hostile ones. Source: Meisters 1975, "Polygons have ears".
[[nodiscard]] EarClipping clip_ears(std::span<const vec3> polygon);

} // namespace atrium
