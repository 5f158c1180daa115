#pragma once
// From a frame's request to its view, and from there to the uniform buffer.

#include "renderer/frame_request.hpp"
#include "renderer/scene/light_set.hpp"
#include "renderer/scene/view.hpp"
#include "shaders/shared/frame.h"

namespace atrium {

/// The view of a request, without what only the engine knows: `previous_exposure`, and whether there was a previous
/// frame.
[[nodiscard]] ViewDescription describe_view(const FrameRequest& request, const Bounds& scene);

[[nodiscard]] shared::FrameConstants make_frame_constants(const View& view, const LightSet& lights,
                                                          const Settings& settings);

} // namespace atrium
