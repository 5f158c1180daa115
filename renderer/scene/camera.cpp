#include "renderer/scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace atrium {
namespace {

using glm::dvec3;

double radians(float degrees)
{
    return static_cast<double>(degrees) * 3.14159265358979323846 / 180.0;
}

struct Axes {
    dvec3 right, up, forward;
};

// Doubles, so that a camera along an axis gets exact zeros and ones, and one far from the origin keeps its precision.
Axes axes_of(const Camera& camera)
{
    const dvec3 d = dvec3(camera.target) - dvec3(camera.eye);
    const double length = glm::length(d);
    const dvec3 forward = length > 0.0 ? d / length : dvec3(0, 0, -1);
    // Within a thousandth of a degree of the vertical, +Y gives no usable direction.
    const bool vertical = forward.x * forward.x + forward.z * forward.z < 1e-10;
    const dvec3 right = glm::normalize(glm::cross(forward, vertical ? dvec3(0, 0, 1) : dvec3(0, 1, 0)));
    return {right, glm::cross(right, forward), forward};
}

bool within_world(const vec3& p)
{
    // Written so that NaN fails.
    return glm::all(glm::greaterThanEqual(p, vec3(world_range.min))) &&
           glm::all(glm::lessThanEqual(p, vec3(world_range.max)));
}

} // namespace

void check_camera(const Camera& camera, ExitCode code, std::string_view where)
{
    const auto fail = [&](const std::string& what, std::string why, std::string next) {
        throw Error(code, what, std::string(where), std::move(why), std::move(next));
    };
    if (!within_world(camera.eye) || !within_world(camera.target)) {
        fail("the camera stands outside the world",
             fmt::format("coordinates go from {} to {} m", world_range.min, world_range.max), "mend eye or target");
    }
    if (!(camera.fov > 1.0f && camera.fov < 170.0f)) {
        fail(fmt::format("bad field of view {}", camera.fov), "it must lie between 1 and 170 degrees",
             "60 is a usual value");
    }
    if (camera.eye == camera.target) {
        fail("the camera's eye and target are the same point", "so it looks nowhere", "move one of them");
    }
}

mat4 view_from_world(const Camera& camera)
{
    const Axes a = axes_of(camera);
    const dvec3 eye(camera.eye);
    glm::dmat4 m(1.0);
    for (int column = 0; column < 3; ++column) {
        m[column][0] = a.right[column];
        m[column][1] = a.up[column];
        m[column][2] = -a.forward[column];
    }
    m[3][0] = -glm::dot(a.right, eye);
    m[3][1] = -glm::dot(a.up, eye);
    m[3][2] = glm::dot(a.forward, eye);
    return mat4(m + glm::dmat4(0.0)); // -0 to +0
}

mat4 clip_from_view(float fov_degrees, float aspect, float near)
{
    const double scale = 1.0 / std::tan(0.5 * radians(fov_degrees));
    mat4 m(0.0f);
    m[0][0] = static_cast<float>(scale / static_cast<double>(aspect));
    m[1][1] = static_cast<float>(scale);
    m[2][3] = -1.0f;
    m[3][2] = near;
    return m;
}

float default_near(const Bounds& bounds)
{
    const float diagonal = bounds.diagonal(), near = std::clamp(diagonal / 20000.0f, 0.001f, 0.1f);
    return diagonal > 0 ? std::min(near, 0.05f * diagonal) : near;
}

} // namespace atrium
