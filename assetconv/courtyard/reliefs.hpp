#pragma once
// Carved lions: round medallions and a framed panel.

#include "assetconv/courtyard/court.hpp"

namespace atrium::courtyard {

/// A disc with the relief inside a turned ring; origin at its middle on the wall, z away from the wall.
void draw_medallion(Court& court, std::string_view group, const mat4& place, float radius);

} // namespace atrium::courtyard
