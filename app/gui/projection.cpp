#include "app/gui/projection.hpp"

#include "renderer/scene/view.hpp"

#include <algorithm>

namespace atrium::gui {
namespace {

constexpr float nearest = 0.05f; // m: what is nearer has no place in the picture

} // namespace

Projection::Projection(const Camera& camera, vec2 display)
    : eye(camera.eye), middle_(0.5f * display), focal_(0.5f * display.y / half_tangent(camera))
{
    const ViewAxes axes = axes_of(camera);
    right = axes.right;
    up = axes.up;
    forward = axes.forward;
}

float Projection::depth(const vec3& point) const
{
    return glm::dot(forward, point - eye);
}

std::optional<vec2> Projection::project(const vec3& point) const
{
    if (depth(point) < nearest) return std::nullopt;
    const vec3 from_eye = point - eye;
    return middle_ + focal_ / depth(point) * vec2(glm::dot(right, from_eye), -glm::dot(up, from_eye));
}

float Projection::pixel_size(const vec3& point) const
{
    return std::max(depth(point), nearest) / focal_;
}

vec3 Projection::in_view_plane(const vec3& point, vec2 pixels) const
{
    return pixel_size(point) * (right * pixels.x - up * pixels.y);
}

} // namespace atrium::gui
