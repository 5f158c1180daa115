#pragma once
// The pictures that the device keeps for a window.

#include <cstdint>

namespace atrium {

/// A window shows one picture, or, left of a divider, another one beside it.
enum class PictureSlot : std::uint8_t { main, other };

} // namespace atrium
