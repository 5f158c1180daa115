#pragma once
// Where the tabs of the panel stand in a window of scale 1.

#include "renderer/core/math.hpp"

namespace atrium::window::tabs {

inline constexpr int y = 140;
inline constexpr ivec2 settings{44, y}, lights{95, y}, buffers{141, y}, camera{193, y}, materials{251, y},
    costs{301, y}, help{338, y};

} // namespace atrium::window::tabs
