#pragma once
// Where the lanterns hang, and which of them are lights of the scene file.

#include "assetconv/courtyard/plan.hpp"

#include <vector>

namespace atrium::courtyard {

struct Lantern {
    SideIndex side;
    int bay;
    bool light; ///< also a point light
};

[[nodiscard]] const std::vector<Lantern>& lanterns();
/// The middle of its glass in the world.
[[nodiscard]] vec3 lantern_position(const Lantern& lantern);

} // namespace atrium::courtyard
