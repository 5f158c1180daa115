#include "tests/truth/primary.hpp"

#include "renderer/core/jobs.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::truth {
namespace {

constexpr double silhouette_plane_share = 0.01; ///< of the depth
constexpr double silhouette_degrees = 25;

double radians(double degrees)
{
    return degrees * 3.14159265358979323846 / 180;
}

/// Rays of length 1 along the view axis, so that distance is depth.
class Lens {
public:
    Lens(const Camera& camera, ivec2 size) : eye_(camera.eye), size_(size)
    {
        forward_ = glm::normalize(dvec3(camera.target) - eye_);
        const bool vertical = std::hypot(forward_.x, forward_.z) < 1e-5;
        right_ = glm::normalize(glm::cross(forward_, vertical ? dvec3(0, 0, 1) : dvec3(0, 1, 0)));
        up_ = glm::cross(right_, forward_);
        const double tangent = std::tan(radians(static_cast<double>(camera.fov)) / 2);
        up_ *= tangent;
        right_ *= tangent * size.x / size.y;
    }
    [[nodiscard]] Ray through(int x, int y, double near) const
    {
        const double u = (x + 0.5) / size_.x, v = (y + 0.5) / size_.y;
        return {eye_, forward_ + (2 * u - 1) * right_ + (1 - 2 * v) * up_, near};
    }

private:
    dvec3 eye_, forward_{0}, right_{0}, up_{0};
    ivec2 size_;
};

void store(float* pixel, const dvec3& v)
{
    for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(v[c]);
}

void store_hit(PrimaryBuffers& b, int x, int y, const Hit& hit)
{
    *b.depth.at(x, y) = static_cast<float>(hit.distance);
    store(b.position.at(x, y), hit.position);
    store(b.geometric_normal.at(x, y), hit.front ? hit.plane_normal : -hit.plane_normal);
    store(b.shading_normal.at(x, y), hit.front ? hit.vertex_normal : -hit.vertex_normal);
    b.uv.at(x, y)[0] = static_cast<float>(hit.uv.x);
    b.uv.at(x, y)[1] = static_cast<float>(hit.uv.y);
    *b.material.at(x, y) = static_cast<float>(hit.material);
    *b.mesh.at(x, y) = static_cast<float>(hit.mesh);
    b.primitive[b.surface.index(x, y)] = hit.primitive;
    b.alpha.set(x, y, hit.alpha);
    b.surface.set(x, y, true);
}

dvec3 load(const ImageF& image, int x, int y)
{
    const float* p = image.at(x, y);
    return {p[0], p[1], p[2]};
}

bool differ(const PrimaryBuffers& b, int x, int y, int u, int v)
{
    if (*b.mesh.at(x, y) != *b.mesh.at(u, v)) return true;
    if (!b.surface.at(x, y)) return false;
    const dvec3 n = load(b.geometric_normal, x, y);
    const double off = std::abs(glm::dot(n, load(b.position, u, v) - load(b.position, x, y)));
    if (off > silhouette_plane_share * static_cast<double>(*b.depth.at(x, y))) return true;
    return glm::dot(n, load(b.geometric_normal, u, v)) < std::cos(radians(silhouette_degrees));
}

} // namespace

PrimaryBuffers::PrimaryBuffers(int w, int h)
    : depth(w, h, 1, std::numeric_limits<float>::infinity()), position(w, h, 3), geometric_normal(w, h, 3),
      shading_normal(w, h, 3), uv(w, h, 2), material(w, h, 1, -1.0f), mesh(w, h, 1, -1.0f),
      primitive(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), no_primitive), alpha(w, h), surface(w, h)
{}

PrimaryBuffers cast_primary(const TruthScene& scene, const Camera& camera, ivec2 size, double near)
{
    PrimaryBuffers buffers(size.x, size.y);
    const Lens lens(camera, size);
    parallel_for(static_cast<std::size_t>(size.y), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < size.x; ++x) {
            if (const auto hit = scene.first_hit(lens.through(x, y, near), Facing::cull)) {
                store_hit(buffers, x, y, *hit);
            }
        }
    });
    return buffers;
}

Mask silhouettes(const PrimaryBuffers& b)
{
    Mask edges(b.depth.width, b.depth.height);
    for (int y = 0; y < edges.height; ++y) {
        for (int x = 0; x < edges.width; ++x) {
            bool edge = false;
            for (int v = std::max(0, y - 1); v <= std::min(edges.height - 1, y + 1); ++v) {
                for (int u = std::max(0, x - 1); u <= std::min(edges.width - 1, x + 1); ++u) {
                    edge = edge || differ(b, x, y, u, v);
                }
            }
            edges.set(x, y, edge);
        }
    }
    return grown(edges);
}

} // namespace atrium::truth
