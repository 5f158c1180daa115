#include "renderer/scene/default_camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace atrium {
namespace {

using glm::dvec3;

/// Calls visit(p) for each point, in the axes of a view with its origin at the world's origin, m.
template <class Visit>
void for_each_point(std::span<const PointSet> sets, const glm::dmat3& view_from_world, Visit visit)
{
    for (const PointSet& set : sets) {
        const glm::dmat4 world(set.world_from_object);
        const glm::dmat3 turn = view_from_world * glm::dmat3(world);
        const dvec3 shift = view_from_world * dvec3(world[3]);
        for (std::size_t i = 0; i < set.count; ++i) {
            vec3 p;
            std::memcpy(&p, set.first + i * set.stride, sizeof(p));
            if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) visit(turn * dvec3(p) + shift);
        }
    }
}

/// Limits along one axis of the picture: two planes that contain all points, framed_share of the frustum apart.
struct Side {
    double slope = 1;                 ///< of the two planes
    double high = -1e300, low = high; ///< largest distance of points beyond parallel planes through the origin
    void add(double x, double z)
    {
        high = std::max(high, x - slope * z);
        low = std::max(low, -x - slope * z);
    }
    [[nodiscard]] double middle() const { return 0.5 * (high - low); }
    /// The farthest position forward from which all points lie between the planes.
    [[nodiscard]] double farthest() const { return -0.5 * (high + low) / slope; }
};

/// The position along one axis of the picture from which the points' projections are centred, seen from depth `eye_z`:
/// computed from the two outermost points, and repeated because these change with the position.
struct Centring {
    double eye = 0;
    double most = 0, least = 0; ///< projections, and the points that have them
    std::array<double, 2> most_at{}, least_at{};
    void begin() { most = -1e300, least = 1e300; }
    void add(double x, double z, double eye_z)
    {
        const double at = (x - eye) / (z - eye_z);
        if (at > most) most = at, most_at = {x, z - eye_z};
        if (at < least) least = at, least_at = {x, z - eye_z};
    }
    void end() { eye = (most_at[0] * least_at[1] + least_at[0] * most_at[1]) / (most_at[1] + least_at[1]); }
};

} // namespace

Camera frame_points(std::span<const PointSet> sets, float fov, float aspect)
{
    Camera camera;
    camera.fov = fov;
    const double above = glm::radians(30.0), aside = glm::radians(30.0); // shows two sides and the top of a block
    const dvec3 forward(-std::cos(above) * std::sin(aside), -std::sin(above), -std::cos(above) * std::cos(aside));
    const dvec3 right = glm::normalize(glm::cross(forward, dvec3(0, 1, 0))), up = glm::cross(right, forward);
    const glm::dmat3 world_from_view(right, up, forward), view_from_world = glm::transpose(world_from_view);

    const double slope = static_cast<double>(framed_share) * std::tan(glm::radians(0.5 * static_cast<double>(fov)));
    Side x{slope * static_cast<double>(aspect)}, y{slope};
    dvec3 low(1e300), high(-1e300);
    for_each_point(sets, view_from_world, [&](const dvec3& p) {
        x.add(p.x, p.z);
        y.add(p.y, p.z);
        low = glm::min(low, p);
        high = glm::max(high, p);
    });
    if (low.x > high.x) return camera;

    // Not closer than the near plane, and not closer than float precision allows.
    const auto size = static_cast<float>(glm::length(high - low));
    Bounds sized;
    sized.add(vec3(0));
    sized.add(vec3(size, 0, 0));
    const double closest =
        std::max(1.5 * static_cast<double>(default_near(sized)), 1e-5 * std::max(glm::length(low), glm::length(high)));
    const double eye_z = std::min({x.farthest(), y.farthest(), low.z - closest});
    Centring across{x.middle()}, along{y.middle()};
    constexpr int rounds = 4;
    for (int round = 0; round < rounds; ++round) {
        across.begin();
        along.begin();
        for_each_point(sets, view_from_world, [&](const dvec3& p) {
            across.add(p.x, p.z, eye_z);
            along.add(p.y, p.z, eye_z);
        });
        across.end();
        along.end();
    }
    const dvec3 eye = world_from_view * dvec3(across.eye, along.eye, eye_z);
    camera.eye = vec3(eye);
    camera.target = vec3(eye + forward * (0.5 * (low.z + high.z) - eye_z));
    return camera;
}

Camera frame_bounds(const Bounds& bounds, float fov, float aspect)
{
    std::array<vec3, 8> corners;
    for (unsigned i = 0; i < corners.size(); ++i) corners[i] = bounds.corner(i);
    const PointSet set{std::as_bytes(std::span(corners)).data(), sizeof(vec3), bounds.empty() ? 0 : corners.size()};
    return frame_points({&set, 1}, fov, aspect);
}

Camera inside_bounds(const Bounds& bounds, float fov)
{
    Camera camera;
    camera.fov = fov;
    if (bounds.empty()) return camera;

    // A third of the height shows floor and ceiling; a person's eye height if that is higher and fits into the room.
    const vec3 extent = bounds.extent();
    const float height = std::max(extent.y / 3.0f, std::min(1.7f, 0.6f * extent.y));
    camera.eye = bounds.centre();
    camera.eye.y = bounds.min.y + height;
    const float reach = std::max({0.5f * extent.x, 0.5f * extent.z, 0.01f});
    camera.target = camera.eye + (extent.x > extent.z ? vec3(reach, 0, 0) : vec3(0, 0, -reach));
    return camera;
}

} // namespace atrium
