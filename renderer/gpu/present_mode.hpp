#pragma once
// How a window's images wait for the display; without Vulkan, since settings name it.

#include <array>
#include <cstdint>

namespace atrium::gpu {

enum class PresentMode : std::uint8_t {
    on,       ///< in turn, one for each of its refreshes
    adaptive, ///< so, but one that comes late at once, be it torn
    off       ///< at once, be it torn, or else the newest at each refresh
};

constexpr auto enum_names(PresentMode)
{
    return std::array{"on", "adaptive", "off"};
}

} // namespace atrium::gpu
