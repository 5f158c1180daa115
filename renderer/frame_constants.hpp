#pragma once
// From what a frame is asked for to its view, and on to the uniform buffer.

#include "renderer/frame_request.hpp"
#include "renderer/scene/light_set.hpp"
#include "renderer/scene/view.hpp"
#include "shaders/shared/frame.h"

namespace atrium {

/// The view of a request, as far as that says it: what was before (`previous_exposure`, and whether there was anything)
/// only the engine knows.
[[nodiscard]] ViewDescription describe_view(const FrameRequest& request, const Bounds& scene);

[[nodiscard]] shared::FrameConstants make_frame_constants(const View& view, const LightSet& lights,
                                                          const Settings& settings);

} // namespace atrium
