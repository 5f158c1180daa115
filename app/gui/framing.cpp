#include "app/gui/framing.hpp"

#include <algorithm>

namespace atrium::gui {
namespace {

/// m, from its middle to its edge.
float extent_of(const Light& light)
{
    return light.type == LightType::rect ? 0.5f * glm::length(vec2(light.width, light.height)) : light.size;
}

} // namespace

Camera frame_light(const Camera& camera, const Light& light, float scene_diagonal)
{
    constexpr float sizes = 4, least_share = 0.02f, most_share = 0.15f;
    Camera out = camera;
    const float before = glm::distance(camera.eye, camera.target);
    if (light.type == LightType::sun) {
        out.target = camera.eye - before * glm::normalize(light.direction);
        return out;
    }
    const float least = std::max(sizes * extent_of(light), least_share * scene_diagonal);
    const float most = std::max(least, most_share * scene_diagonal);
    const float distance = glm::distance(camera.eye, light.position);
    const vec3 forward =
        distance > 0 ? (light.position - camera.eye) / distance : (camera.target - camera.eye) / before;
    out.eye = light.position - std::clamp(distance, least, most) * forward;
    out.target = light.position;
    return out;
}

} // namespace atrium::gui
