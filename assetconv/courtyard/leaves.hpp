#pragma once
// Leaf cards: small quads that carry one cell of an atlas.

#include "assetconv/courtyard/court.hpp"

namespace atrium::courtyard {

/// Cells of the atlases, two by two, (0, 0) lower left. In each a sprig or frond grows upwards from the middle of the
/// foot.
inline constexpr vec2 cell_ivy{0, 0}, cell_citrus{1, 0}, cell_geranium{0, 1}, cell_blossom{1, 1}; // leaf
inline constexpr vec2 cell_fern{0, 0}, cell_raceme{1, 0}, cell_pinnate{0, 1}, cell_agave{1, 1};   // frond

struct LeafCard {
    vec3 foot{0};
    vec3 along{0, 1, 0};  ///< unit, from the stalk to the tip
    vec3 facing{0, 0, 1}; ///< where the upper side looks, roughly
    float length = 0.1f, width = 0.1f;
    float droop = 0; ///< how far the tip has bent down, radians
    int pieces = 1;  ///< along the length
    vec2 cell{0};
    vec3 rounded{0}; ///< added to the normals: a bush shades as one body
};
void draw_leaf_card(Pen& pen, const LeafCard& card);

/// A unit vector, any direction alike.
[[nodiscard]] vec3 any_direction(Random& random);

} // namespace atrium::courtyard
