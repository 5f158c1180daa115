#pragma once
// What each setting changes, and thereby what it must leave alone: one table, in which a new setting needs a row.

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

/// A change of one setting, from what `base` and the defaults say to `value`.
struct Effect {
    const char* key;
    const char* value;
    std::vector<std::pair<const char*, const char*>> base; ///< set before
    std::vector<const char*> changes;                      ///< outputs of which each must change
    std::vector<const char*> may_change;                   ///< others that it may change; all the rest must not
    Place place = Place::court;
};

/// Outputs are AOVs by name (lights: sun, spot, point, rect), "picture", and "triangles", the number that is drawn.
/// Names are patterns with * and ?. A setting may have several rows.
[[nodiscard]] std::span<const Effect> table();

/// Before every row's own base: what takes part is on, and small.
[[nodiscard]] std::span<const std::pair<const char*, const char*>> common_base();

} // namespace atrium::effects
