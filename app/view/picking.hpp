#pragma once
// What is seen at a pixel.

#include "renderer/engine.hpp"

#include <cstddef>
#include <optional>

namespace atrium::app {

/// The material that the frame shows there; none in the background. Draws the frame's G-buffer. Throws Error.
[[nodiscard]] std::optional<std::size_t> material_at(Engine& engine, FrameRequest frame, uvec2 pixel);

} // namespace atrium::app
