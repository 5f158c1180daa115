#pragma once
// Sets of points, random but even, for filtering soft shadows.
// Source: Yuksel 2015, "Sample Elimination for Generating Poisson Disk Sample Sets".

#include "renderer/core/math.hpp"

#include <cstdint>
#include <vector>

namespace atrium {

/// `count` (4..64) points of the unit disc, the same for a seed on every platform. No two are closer than .69 of what
/// the densest packing of as many would leave between them, and their mean lies within .03 of the centre. Progressive:
/// for the first 4, 8, 16 ... it is about .6. Takes a millisecond or two. Throws std::logic_error for another count.
[[nodiscard]] std::vector<vec2> disc_samples(int count, std::uint64_t seed);

/// Moves the points of a disc's set by a share of the way to radii that hold equal areas, which elimination alone does
/// not give: it leaves points at the rim, where they have no neighbours outside. A straight edge then covers so many
/// points as it covers of the disc, to a quarter better. All of the way is best for the mean of many turned sets; in
/// one alone points then come too close to each other.
void even_out_radii(std::vector<vec2>& disc, float share = 0.7f);

/// The same in the square [-1, 1)², where distances go around its sides: shifted modulo the square, a set is as even.
/// The first 4, 8, 16 ... keep about .5. The mean is that of the set as it stands.
[[nodiscard]] std::vector<vec2> square_samples(int count, std::uint64_t seed);

/// r_max: the radius of `count` equal discs, packed as densely as the plane can be, that fill a domain of this area.
[[nodiscard]] double packing_radius(double area, int count);

/// How much a point at this distance crowds another: 0 from 2 r_max on, the same for all below 2 r_min, so that a close
/// pair is not taken for a crowd.
[[nodiscard]] float elimination_weight(double distance, double r_min, double r_max);

} // namespace atrium
