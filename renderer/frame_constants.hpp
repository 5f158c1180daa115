#pragma once
// From camera, lights and settings to the uniform buffer of a frame.

#include "renderer/engine.hpp"
#include "shaders/shared/frame.h"

namespace atrium {

[[nodiscard]] shared::FrameConstants make_frame_constants(const FrameRequest& request, const GpuScene& scene);

} // namespace atrium
