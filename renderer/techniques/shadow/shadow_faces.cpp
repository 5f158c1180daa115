#include "renderer/techniques/shadow/shadow_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atrium {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr float cascade_lambda = 0.75f;
constexpr float cascade_far = 100;                ///< m; what lies beyond is left to the last cascade
constexpr float cascade_near_share = 1.0f / 1000; ///< of the far end: where the first slice begins

/// Tangents beyond what is lit. What hides the rim of a light of 1 m radius and stands 1.5 m from it is still found;
/// more would cost too much of the resolution.
float guard_band(float extent)
{
    return std::clamp(extent / 1.5f, 0.035f, 0.3f);
}

struct Axes {
    vec3 x, y, z;
};

vec4 row(const vec3& axis, const vec3& origin, float scale)
{
    return vec4(axis, -glm::dot(axis, origin)) / scale;
}

shared::ShadowFace face_from(const vec3& origin, const Axes& a, float scale)
{
    return {row(a.x, origin, scale), row(a.y, origin, scale), row(a.z, origin, 1), scale};
}

/// Axes of a view along z, whatever way it is turned around it.
Axes axes_along(const vec3& z, const vec3& up)
{
    const vec3 x = glm::normalize(glm::cross(z, up));
    return {x, glm::cross(x, z), z};
}

LightFaces cube_faces(const Light& light, const Bounds& scene, float extent)
{
    Axes base{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    const bool whole = light.type == LightType::point;
    if (!whole) {
        const LightAxes axes = axes_of(light);
        base = {axes.right, axes.up, axes.direction};
    }
    LightFaces out;
    out.depth_scale = out.near = default_near(scene);
    const float scale = 1 + guard_band(extent);
    for (const auto& [z, up] : {std::pair{base.x, base.y},
                                {-base.x, base.y},
                                {base.y, base.z},
                                {-base.y, base.z},
                                {base.z, base.y},
                                {-base.z, base.y}})
        out.faces.push_back(face_from(light.position, axes_along(z, up), scale));
    if (!whole) out.faces.pop_back();
    return out;
}

LightFaces spot_faces(const Light& light, const Bounds& scene, float extent)
{
    const LightAxes axes = axes_of(light);
    const float scale = std::tan(glm::radians(light.outer)) + guard_band(extent);
    return {{face_from(light.position, {axes.right, axes.up, axes.direction}, scale)},
            true,
            default_near(scene),
            default_near(scene)};
}

/// A tile of the sun's map, `radius` m around a centre in its light's own axes.
shared::ShadowFace sun_face(const Axes& a, const dvec2& centre, double near, double radius)
{
    const auto at = [&](const vec3& axis, double middle, double scale) {
        return vec4(vec3(dvec3(axis) / scale), static_cast<float>(-middle / scale));
    };
    return {at(a.x, centre.x, radius), at(a.y, centre.y, radius), at(a.z, near, 1), static_cast<float>(radius)};
}

LightFaces sun_faces(const Light& light, const Bounds& scene, const CascadeFit& fit)
{
    const LightAxes own = axes_of(light);
    const Axes axes{own.right, own.up, own.direction};
    dvec3 low(1e30), high(-1e30); // of the scene, in the light's axes
    for (unsigned n = 0; n < 8; ++n) {
        const dvec3 p(scene.corner(n));
        const dvec3 q(glm::dot(p, dvec3(axes.x)), glm::dot(p, dvec3(axes.y)), glm::dot(p, dvec3(axes.z)));
        low = glm::min(low, q);
        high = glm::max(high, q);
    }
    const double margin = 0.01 * std::max(static_cast<double>(scene.diagonal()), 1e-3);
    const double near = low.z - margin;
    LightFaces out;
    out.perspective = false;
    out.near = static_cast<float>(near);
    out.depth_scale = static_cast<float>(high.z + margin - near);

    const dvec2 middle(0.5 * (low.x + high.x), 0.5 * (low.y + high.y));
    const double whole = 0.5 * std::max(high.x - low.x, high.y - low.y) + margin;
    const double tan_y = std::tan(glm::radians(0.5 * static_cast<double>(fit.camera.fov)));
    const double k2 = tan_y * tan_y * (1 + static_cast<double>(fit.aspect) * static_cast<double>(fit.aspect));
    const float far = std::min(cascade_far, scene.diagonal());
    const std::vector<float> ends = cascade_splits(far * cascade_near_share, far, fit.count, cascade_lambda);
    const dvec3 eye(fit.camera.eye), forward = glm::normalize(dvec3(fit.camera.target) - eye);
    double from = static_cast<double>(far * cascade_near_share);
    for (int i = 0; i + 1 < fit.count; ++i) {
        const double to = static_cast<double>(ends[static_cast<std::size_t>(i)]);
        const SliceSphere sphere = slice_sphere(from, to, k2);
        from = to;
        if (sphere.radius >= whole) break; // the whole scene is smaller
        const dvec3 centre = eye + sphere.centre * forward;
        const double texel = 2 * sphere.radius / fit.side;
        const dvec2 snapped =
            texel * glm::floor(dvec2(glm::dot(centre, dvec3(axes.x)), glm::dot(centre, dvec3(axes.y))) / texel);
        out.faces.push_back(sun_face(axes, snapped, near, sphere.radius));
    }
    while (static_cast<int>(out.faces.size()) < fit.count) out.faces.push_back(sun_face(axes, middle, near, whole));
    return out;
}

} // namespace

std::vector<float> cascade_splits(float near, float far, int count, float lambda)
{
    std::vector<float> ends;
    for (int i = 1; i <= count; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(count);
        ends.push_back(lambda * near * std::pow(far / near, share) + (1 - lambda) * (near + (far - near) * share));
    }
    return ends;
}

SliceSphere slice_sphere(double from, double to, double k2)
{
    const double centre = std::min(to, 0.5 * (from + to) * (1 + k2));
    return {centre, std::sqrt((to - centre) * (to - centre) + k2 * to * to)};
}

LightFaces light_faces(const Light& light, const Bounds& scene, const CascadeFit& fit, float extent)
{
    switch (light.type) {
    case LightType::sun:
        return sun_faces(light, scene, fit);
    case LightType::spot:
        return spot_faces(light, scene, extent);
    default:
        return cube_faces(light, scene, extent);
    }
}

} // namespace atrium
