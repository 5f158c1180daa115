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

/// Moves a disc's set a little, to radii that hold equal areas, with a mean near the centre, which elimination alone
/// does not give: it leaves points at the rim, where they have no neighbours outside. What a straight edge covers of
/// the disc is then found in points to half of the error, and with none on average.
void even_out(std::vector<vec2>& disc);

/// The same in the square [-1, 1)², where distances go around its sides: shifted modulo the square, a set is as even.
/// The first 4, 8, 16 ... keep about .5. The mean is that of the set as it stands.
[[nodiscard]] std::vector<vec2> square_samples(int count, std::uint64_t seed);

/// `count` points of the unit disc along a spiral, each a golden angle from the one before, at radii that hold equal
/// areas. Source: Vogel 1979, "A Better Way to Construct the Sunflower Head". What a straight edge covers is found to
/// half of the error of the even sets above; but neighbouring pixels' arms would show where few samples make much
/// noise.
[[nodiscard]] std::vector<vec2> spiral_samples(int count);

/// The same for the square [-1, 1)²: a lattice whose rows and columns are all at different places, evenly apart.
/// Source: Korobov 1959, "On the Approximate Computation of Multiple Integrals"; golden steps.
[[nodiscard]] std::vector<vec2> lattice_samples(int count);

/// r_max: the radius of `count` equal discs, packed as densely as the plane can be, that fill a domain of this area.
[[nodiscard]] double packing_radius(double area, int count);

/// How much a point at this distance crowds another: 0 from 2 r_max on, the same for all below 2 r_min, so that a close
/// pair is not taken for a crowd.
[[nodiscard]] float elimination_weight(double distance, double r_min, double r_max);

} // namespace atrium
