// A camera for scenes that name none.

#include "app/scene_input.hpp"

#include "renderer/core/jobs.hpp"
#include "renderer/core/log.hpp"
#include "renderer/scene/default_camera.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace atrium::app {
namespace {

constexpr int ray_count = 64;
constexpr float enclosed_share = 0.6f; ///< of the rays that must meet the front of a surface
constexpr float free_distance = 0.02f; ///< of the diagonal, to the nearest surface
constexpr float room_distance = 0.06f; ///< of the diagonal: objects in a room are farther away, seats of a car are not
constexpr float crowded_share = 0.1f;  ///< of the rays: so many in a room may hit something closer than room_distance

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

/// `d` need not be a unit vector.
bool ray_meets_sphere(const vec3& origin, const vec3& d, const Cluster& c)
{
    const vec3 to = c.centre - origin;
    const float along = glm::dot(to, d), d2 = glm::dot(d, d), r2 = c.radius * c.radius;
    return (glm::dot(to, to) - r2) * d2 <= along * along && (along >= 0 || glm::dot(to, to) <= r2);
}

void cast(const BakeFile& bake, std::span<const Cluster> clusters, const vec3& origin, const vec3& d, Hit& best)
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
    for (const Cluster& c : clusters) {
        if (!ray_meets_sphere(origin, d, c)) continue;
        for (std::size_t i = c.first_index; i + 2 < std::size_t{c.first_index} + c.index_count; i += 3) {
            intersect(origin, d, position(index(i)), position(index(i + 1)), position(index(i + 2)), best);
        }
    }
}

/// The part of its bake that an instance shows.
struct Part {
    std::span<const Cluster> clusters;
    std::size_t first_vertex = 0, vertex_count = 0;
    Bounds bounds;
};

Part part_of(const Scene& scene, const Instance& instance)
{
    if (!instance.mesh) return {scene.clusters, 0, scene.vertex_count, scene.bounds};
    const Mesh& mesh = scene.meshes[*instance.mesh];
    return {std::span(scene.clusters).subspan(mesh.first_cluster, mesh.cluster_count), mesh.first_vertex,
            mesh.vertex_count, mesh.bounds};
}

Hit cast(const SceneInput& scene, const vec3& origin, const vec3& d)
{
    Hit best;
    for (const Instance& instance : scene.instances) {
        const BakeFile& bake = *scene.bakes[instance.bake];
        const mat4 object_from_world = glm::inverse(instance.world_from_object);
        Hit hit = best;
        cast(bake, part_of(bake.scene(), instance).clusters, vec3(object_from_world * vec4(origin, 1)),
             mat3(object_from_world) * d, hit);
        if (hit.t >= best.t) continue;
        best = hit;
        if (glm::determinant(mat3(object_from_world)) < 0) best.front = !best.front;
    }
    return best;
}

Bounds bounds_of(const SceneInput& scene)
{
    Bounds all;
    for (const Instance& instance : scene.instances) {
        const Bounds own = part_of(scene.bakes[instance.bake]->scene(), instance).bounds;
        all.add(transformed(own, instance.world_from_object));
    }
    return all;
}

Camera outside_of(const SceneInput& scene, float fov, float aspect)
{
    std::vector<PointSet> sets;
    for (const Instance& instance : scene.instances) {
        const BakeFile& bake = *scene.bakes[instance.bake];
        const Part part = part_of(bake.scene(), instance);
        sets.push_back({bake.vertices().data() + part.first_vertex * sizeof(Vertex), sizeof(Vertex), part.vertex_count,
                        instance.world_from_object});
    }
    return frame_points(sets, fov, aspect);
}

/// Whether the middle of the scene is in a room: no surface is very close, few are near, and most rays from there hit
/// the front of a surface.
bool is_room(const SceneInput& scene, const Bounds& bounds)
{
    std::atomic<int> fronts = 0, close_hits = 0, near_hits = 0;
    parallel_for(ray_count, [&](std::size_t i) {
        const Hit hit = cast(scene, bounds.centre(), direction(static_cast<int>(i)));
        if (hit.front) ++fronts;
        if (hit.t < free_distance * bounds.diagonal()) ++close_hits;
        if (hit.t < room_distance * bounds.diagonal()) ++near_hits;
    });
    log_verbose(fmt::format("from the middle {} of {} rays hit the front of a surface, {} closer than {:.2g} m",
                            fronts.load(), ray_count, near_hits.load(), room_distance * bounds.diagonal()));
    return close_hits == 0 && static_cast<float>(near_hits) <= crowded_share * ray_count &&
           static_cast<float>(fronts) >= enclosed_share * ray_count;
}

bool camera_is_given(const SceneInput& scene, const FrameOptions& o)
{
    return o.eye || !o.camera.empty() || scene.config.camera || !scene.file.cameras.empty();
}

} // namespace

void find_camera(SceneInput& scene, const FrameOptions& o)
{
    scene.found.reset();
    if (camera_is_given(scene, o)) return;
    const float fov = o.fov.value_or(Camera{}.fov);
    const vec2 size(picture_size(o, scene));
    const Bounds bounds = bounds_of(scene);
    FoundCamera found;
    found.inside =
        o.from == CameraFrom::inside || (o.from == CameraFrom::anywhere && !bounds.empty() && is_room(scene, bounds));
    found.camera = found.inside ? inside_bounds(bounds, fov) : outside_of(scene, fov, size.x / size.y);
    scene.found = found;
}

} // namespace atrium::app
