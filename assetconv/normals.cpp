#include "assetconv/normals.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace atrium {
namespace {

/// Around a point with more triangles than this the angle between pairs is not looked at: that would be quadratic.
constexpr std::size_t max_fan = 512;

struct Incident {
    glm::dvec3 normal; ///< unit
    double angle;      ///< of the triangle at the point, radians
    std::uint32_t smoothing;
    SourceTriangle* triangle;
    std::size_t corner;
};

double angle_between(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Triangles around every point, in file order: counting sort by position.
struct Incidence {
    std::vector<std::uint32_t> first; ///< positions + 1
    std::vector<Incident> incidents;
};

Incidence gather(SourceScene& scene)
{
    Incidence all;
    all.first.assign(scene.positions.size() + 1, 0);
    const auto each_corner = [&](auto&& body) {
        for (SourceMesh& mesh : scene.meshes) {
            for (SourceTriangle& t : mesh.triangles) {
                for (std::size_t i = 0; i < 3; ++i) body(t, i, static_cast<std::size_t>(t.corners[i].position));
            }
        }
    };
    each_corner([&](SourceTriangle&, std::size_t, std::size_t p) { ++all.first[p + 1]; });
    for (std::size_t p = 0; p + 1 < all.first.size(); ++p) all.first[p + 1] += all.first[p];
    all.incidents.resize(all.first.back());
    std::vector<std::uint32_t> next = all.first;
    each_corner([&](SourceTriangle& t, std::size_t i, std::size_t p) {
        const auto at = [&](std::size_t k) {
            return glm::dvec3(scene.positions[static_cast<std::size_t>(t.corners[k % 3].position)]);
        };
        const double angle = angle_between(at(i + 1) - at(i), at(i + 2) - at(i));
        all.incidents[next[p]++] = {glm::normalize(area_normal(scene, t)), angle, t.smoothing, &t, i};
    });
    return all;
}

vec3 smoothed(const Incident& own, std::span<const Incident> around, std::optional<float> forced_angle)
{
    const bool by_angle = forced_angle.has_value() || own.smoothing == smoothing_unset;
    if (!by_angle && own.smoothing == 0) return vec3(own.normal);
    const double limit = std::cos(glm::radians(static_cast<double>(forced_angle.value_or(default_smooth_angle))));
    const bool crowded = around.size() > max_fan;
    glm::dvec3 sum(0);
    for (const Incident& other : around) {
        const bool takes_part = by_angle
                                    ? crowded || &other == &own || glm::dot(own.normal, other.normal) >= limit - 1e-9
                                    : other.smoothing == own.smoothing;
        if (takes_part) sum += other.normal * other.angle;
    }
    const double length = glm::length(sum);
    return vec3(length > 1e-9 ? sum / length : own.normal);
}

} // namespace

void generate_normals(SourceScene& scene, std::optional<float> smooth_angle)
{
    const auto missing = [](const SourceTriangle& t) {
        return std::any_of(t.normals.begin(), t.normals.end(), [](const vec3& n) { return n == vec3(0); });
    };
    const bool any = std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const SourceMesh& m) {
        return std::any_of(m.triangles.begin(), m.triangles.end(), missing);
    });
    if (!any) return;
    const Incidence all = gather(scene);
    for (std::size_t p = 0; p < scene.positions.size(); ++p) {
        const std::span<const Incident> around(all.incidents.data() + all.first[p], all.first[p + 1] - all.first[p]);
        // Around a crowded point all corners of one smoothing value get the same sum: once is enough.
        std::map<std::uint32_t, vec3> known;
        for (const Incident& own : around) {
            vec3& n = own.triangle->normals[own.corner];
            if (n != vec3(0)) continue;
            const bool shared = around.size() > max_fan && (smooth_angle || own.smoothing != 0);
            const std::uint32_t key = smooth_angle ? 0 : own.smoothing;
            const auto found = shared ? known.find(key) : known.end();
            n = found != known.end() ? found->second : smoothed(own, around, smooth_angle);
            if (shared) known.emplace(key, n);
        }
    }
}

} // namespace atrium
