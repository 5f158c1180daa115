#pragma once
// The table of linearly transformed cosines, assets/ltc/table.inc, as shaders/lib/ltc.glsl reads it.

#include "shaders/shared/ltc.h"

#include <span>

namespace atrium {

/// ltc_size rows of ltc_size entries.
[[nodiscard]] std::span<const shared::LtcEntry> ltc_table();

} // namespace atrium
