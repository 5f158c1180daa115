// A camera for scenes that name none.

#include "app/scene_input.hpp"

#include "renderer/core/jobs.hpp"

#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

namespace atrium::app {
namespace {

constexpr int ray_count = 64;
constexpr float enclosed_share = 0.6f; ///< of the rays that must meet the front of a surface
constexpr float free_distance = 0.02f; ///< of the diagonal, to the nearest surface

struct Hit {
    float t = std::numeric_limits<float>::infinity();
    bool front = false;
};

/// Directions spread evenly over the sphere (Fibonacci lattice).
vec3 direction(int i)
{
    const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / ray_count;
    const float r = std::sqrt(1.0f - y * y), angle = 2.39996323f * static_cast<float>(i);
    return {r * std::cos(angle), y, r * std::sin(angle)};
}

/// Source: Möller & Trumbore 1997.
void intersect(const vec3& origin, const vec3& d, const vec3& a, const vec3& b, const vec3& c, Hit& best)
{
    const vec3 ab = b - a, ac = c - a, p = glm::cross(d, ac);
    const float det = glm::dot(ab, p);
    if (std::abs(det) < 1e-12f) return;
    const vec3 s = origin - a, q = glm::cross(s, ab);
    const float u = glm::dot(s, p) / det, v = glm::dot(d, q) / det, t = glm::dot(ac, q) / det;
    if (u < 0 || v < 0 || u + v > 1 || t <= 0 || t >= best.t) return;
    best = {t, det > 0};
}

bool ray_meets_sphere(const vec3& origin, const vec3& d, const Cluster& c)
{
    const vec3 to = c.centre - origin;
    const float along = glm::dot(to, d), r2 = c.radius * c.radius;
    return glm::dot(to, to) - along * along <= r2 && along >= -c.radius;
}

Hit cast(const BakeFile& bake, const vec3& origin, const vec3& d)
{
    const auto* vertices = bake.vertices().data();
    const auto* indices = bake.indices().data();
    const std::uint64_t vertex_count = bake.scene().vertex_count;
    const auto index = [&](std::size_t i) {
        std::uint32_t value = 0;
        std::memcpy(&value, indices + 4 * i, 4);
        return value < vertex_count ? value : 0; // bulk data is not verified at loading
    };
    const auto position = [&](std::uint32_t i) {
        vec3 p;
        std::memcpy(&p, vertices + std::size_t{i} * sizeof(Vertex), sizeof(p));
        return p;
    };
    Hit best;
    for (const Cluster& c : bake.scene().clusters) {
        if (!ray_meets_sphere(origin, d, c)) continue;
        for (std::size_t i = c.first_index; i + 2 < std::size_t{c.first_index} + c.index_count; i += 3) {
            intersect(origin, d, position(index(i)), position(index(i + 1)), position(index(i + 2)), best);
        }
    }
    return best;
}

} // namespace

Camera find_camera(const BakeFile& bake, float fov, float aspect)
{
    const Bounds& bounds = bake.scene().bounds;
    if (bounds.empty() || bake.scene().vertex_count == 0) return frame_bounds(bounds, fov, aspect);
    std::atomic<int> fronts = 0, near_hits = 0;
    parallel_for(ray_count, [&](std::size_t i) {
        const Hit hit = cast(bake, bounds.centre(), direction(static_cast<int>(i)));
        if (hit.front) ++fronts;
        if (hit.t < free_distance * bounds.diagonal()) ++near_hits;
    });
    const bool inside = near_hits == 0 && static_cast<float>(fronts) >= enclosed_share * ray_count;
    return inside ? inside_bounds(bounds, fov) : frame_bounds(bounds, fov, aspect);
}

} // namespace atrium::app
