#include "app/gui/light_view.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::gui {
namespace {

constexpr float least_fov = 1.5f; // degrees, which a camera may have

Camera view_of_sun(const Light& sun, const Bounds& scene)
{
    constexpr float distance = 4; // of the radius: far enough for nearly parallel rays
    const float radius = std::max(0.5f * scene.diagonal(), 1e-3f);
    Camera camera;
    camera.target = scene.centre();
    camera.eye = camera.target - distance * radius * glm::normalize(sun.direction);
    camera.fov = glm::degrees(2 * std::asin(1 / distance));
    return camera;
}

} // namespace

Camera view_of_light(const Light& light, const Camera& camera, const Bounds& scene)
{
    if (light.type == LightType::sun) return view_of_sun(light, scene);
    const vec3 ahead = camera.target - camera.eye;
    Camera out = camera;
    out.eye = light.position;
    out.target = light.position +
                 (light.type == LightType::point ? ahead : glm::length(ahead) * glm::normalize(light.direction));
    if (light.type == LightType::spot) out.fov = std::max(2 * light.outer, least_fov);
    return out;
}

bool LightView::toggle(Camera& camera, const Light* light, const Bounds& scene)
{
    if (before_) {
        camera = *before_;
        before_.reset();
        return true;
    }
    if (light == nullptr) return false;
    before_ = camera;
    camera = view_of_light(*light, camera, scene);
    return true;
}

} // namespace atrium::gui
