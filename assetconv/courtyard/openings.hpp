#pragma once
// Where the outer walls have doors and shuttered windows: the walls leave the holes, the joiners fill them.

#include "assetconv/courtyard/plan.hpp"

#include <optional>
#include <vector>

namespace atrium::courtyard {

struct Opening {
    SideIndex side;
    int bay;
    bool upper;
    float half_width, height;
    bool shutters; ///< green louvred leaves in place of a plank door
};

inline constexpr float opening_depth = 0.16f; ///< of the leaves behind the wall's face

[[nodiscard]] const std::vector<Opening>& openings();
[[nodiscard]] std::optional<Opening> opening_of(int side, int bay, bool upper);

} // namespace atrium::courtyard
