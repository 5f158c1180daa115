#pragma once
// The pictures that the device keeps for a window.

#include <cstdint>

namespace atrium {

/// A window shows the main picture and, in a split view, another one left of the divider.
enum class PictureSlot : std::uint8_t { main, other };

} // namespace atrium
