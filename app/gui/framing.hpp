#pragma once
// Where a camera goes to show one thing.

#include "renderer/scene/camera.hpp"
#include "renderer/scene/light.hpp"

namespace atrium::gui {

/// `camera` turned to a light, which then lies in the middle of the picture, and moved along that line until it is
/// neither nearer than the light is large nor farther than a share of the scene (`scene_diagonal`, m). Of a sun, which
/// stands nowhere, it turns to where it shines from.
[[nodiscard]] Camera frame_light(const Camera& camera, const Light& light, float scene_diagonal);

} // namespace atrium::gui
