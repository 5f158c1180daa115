#pragma once
// Looking through a light: the camera stands where it stands and sees what it lights.

#include "renderer/scene/camera.hpp"
#include "renderer/scene/light.hpp"

#include <optional>

namespace atrium::gui {

/// The camera at a light, as far from its target as `camera` is. Of a spot, its outer cone fills the picture's height;
/// of a rectangle, it looks along the normal; a point has no direction, and `camera` keeps its own. Of a sun, it stands
/// far behind the scene's bounds, which fill the height.
[[nodiscard]] Camera view_of_light(const Light& light, const Camera& camera, const Bounds& scene);

/// Goes to a light, and back to where the camera was.
class LightView {
public:
    /// Back where it has been to one, else to `light`; without one (null) it stays. Whether it went.
    bool toggle(Camera& camera, const Light* light, const Bounds& scene);

private:
    std::optional<Camera> before_;
};

} // namespace atrium::gui
