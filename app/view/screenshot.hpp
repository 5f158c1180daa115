#pragma once
// What the window shows, as files that tell how to draw it again.

#include "renderer/engine.hpp"

#include <string>

namespace atrium::app {

/// Draws the frame as `render` does and writes it into the present folder, numbered: as a PNG and, linear and before
/// exposure, as an EXR. Each carries settings, camera, lights and size. The answer names the files. Throws Error.
[[nodiscard]] std::string write_screenshot(Engine& engine, FrameRequest frame);

} // namespace atrium::app
