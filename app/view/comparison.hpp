#pragma once
// Pictures beside what they approximate.

#include "renderer/engine.hpp"

#include <string>

namespace atrium::app {

/// Of two pictures of one size: the absolute differences of their values times `factor`, at most 255.
[[nodiscard]] Image8 amplified_difference(const Image8& a, const Image8& b, int factor);

/// Draws the frame as it is and with shadow.filter = reference, and writes both and their difference x 4 into the
/// present folder, numbered. The answer names the files. Throws Error.
[[nodiscard]] std::string write_comparison(Engine& engine, FrameRequest frame);

} // namespace atrium::app
