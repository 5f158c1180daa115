#pragma once
// Which outputs each setting changes; all others must stay the same. A new setting needs a row in the table.

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace atrium::effects {

enum class Place {
    court,  ///< the courtyard along its length: textures, normal maps, masks
    open,   ///< a box and a plate on a floor that ends: sky above, and below the horizon; no textures
    masked, ///< a square of many small holes in front of a wall
};

/// A change of one setting to `value`, starting from the defaults and `base`.
struct Effect {
    const char* key;
    const char* value;
    std::vector<std::pair<const char*, const char*>> base; ///< set before
    std::vector<const char*> changes;                      ///< outputs that must all change
    std::vector<const char*> may_change;                   ///< outputs that may change; all others must not
    Place place = Place::court;
};

/// Outputs are AOVs by name (lights: sun, spot, point, rect), "picture", and "triangles", the number that is drawn.
/// Names are patterns with * and ?. A setting may have several rows.
[[nodiscard]] std::span<const Effect> table();

/// Set before every row's base: techniques on, sizes small.
[[nodiscard]] std::span<const std::pair<const char*, const char*>> common_base();

} // namespace atrium::effects
