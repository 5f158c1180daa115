#pragma once
// Where insets stand: right of the panel, in rows from the bottom up.

#include "renderer/core/math.hpp"

#include <cstddef>

namespace atrium::gui {

/// Pixels, all alike.
struct InsetLayout {
    uvec2 image{1};  ///< of each buffer
    uvec2 step{1};   ///< from one inset to the next, and from a row to the one above
    uvec2 origin{0}; ///< lower left corner of the first
    std::size_t columns = 1;
    bool with_legend = true; ///< else there is no room for it
};

/// As large as fits, with legends if they do. Below what the smallest need, the uppermost rows are cut off.
[[nodiscard]] InsetLayout lay_out_insets(uvec2 window, float scale, std::size_t count);

} // namespace atrium::gui
