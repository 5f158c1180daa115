#include "assetconv/clusters.hpp"

#include "renderer/scene/vertex_packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace atrium {
namespace {

/// A bumpy sphere of 2 x n x n triangles with outward winding, far from the origin.
IndexedMesh bumpy_sphere(std::uint32_t n)
{
    IndexedMesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const float theta = pi * static_cast<float>(j) / static_cast<float>(n);
            const float phi = 2 * pi * static_cast<float>(i) / static_cast<float>(n);
            const vec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            const float r = 1 + 0.1f * std::sin(7 * theta) * std::sin(5 * phi);
            mesh.vertices.push_back({vec3(20, 3, -15) + d * r, pack_normal(d), 0, {phi, theta}});
        }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * n + i, b = j * n + (i + 1) % n, c = a + n, d = b + n;
            if (j > 0) mesh.indices.insert(mesh.indices.end(), {a, b, c});
            if (j + 1 < n) mesh.indices.insert(mesh.indices.end(), {b, d, c});
        }
    }
    return mesh;
}

using Corner = std::array<float, 3>;
std::multiset<std::array<Corner, 3>> triangles_of(const std::vector<Vertex>& vertices,
                                                  const std::vector<std::uint32_t>& indices)
{
    std::multiset<std::array<Corner, 3>> all;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::array<Corner, 3> t;
        for (std::size_t k = 0; k < 3; ++k) {
            const vec3& p = vertices.at(indices[i + k]).position;
            t[k] = {p.x, p.y, p.z};
        }
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        all.insert(t);
    }
    return all;
}

TEST(clusters, partition_the_index_buffer_and_keep_every_triangle)
{
    const IndexedMesh mesh = bumpy_sphere(60);
    const auto before = triangles_of(mesh.vertices, mesh.indices);
    const ClusteredMesh out = build_clusters(mesh, false);
    EXPECT_EQ(triangles_of(out.vertices, out.indices), before); // winding included
    std::uint32_t next = 0;
    for (const Cluster& c : out.clusters) {
        EXPECT_EQ(c.first_index, next);
        EXPECT_LE(c.index_count, cluster_max_triangles * 3);
        EXPECT_EQ(c.index_count % 3, 0u);
        std::set<std::uint32_t> vertices(out.indices.begin() + c.first_index,
                                         out.indices.begin() + c.first_index + c.index_count);
        EXPECT_LE(vertices.size(), cluster_max_vertices);
        next += c.index_count;
    }
    EXPECT_EQ(next, out.indices.size());
    // Fetch order: a vertex's first use never skips ahead.
    std::uint32_t seen = 0;
    for (const std::uint32_t i : out.indices) {
        ASSERT_LE(i, seen);
        seen = std::max(seen, i + 1);
    }
}

TEST(clusters, spheres_and_cones_never_cull_what_can_be_seen)
{
    const ClusteredMesh out = build_clusters(bumpy_sphere(60), false);
    std::mt19937 random(3);
    std::normal_distribution<float> spread(0, 2);
    std::size_t culled = 0, tested = 0;
    for (int k = 0; k < 300; ++k) {
        const vec3 eye = vec3(20, 3, -15) + vec3(spread(random), spread(random), spread(random));
        for (const Cluster& c : out.clusters) {
            const vec3 d = c.centre - eye;
            ++tested;
            const bool away = glm::dot(d, c.cone_axis) >= c.cone_cutoff * glm::length(d) + c.radius;
            culled += away ? 1 : 0;
            for (std::uint32_t i = c.first_index; i < c.first_index + c.index_count; i += 3) {
                const glm::dvec3 p(out.vertices[out.indices[i]].position), q(out.vertices[out.indices[i + 1]].position),
                    r(out.vertices[out.indices[i + 2]].position);
                ASSERT_LE(glm::distance(p, glm::dvec3(c.centre)), c.radius);
                if (!away) continue;
                const glm::dvec3 n = glm::cross(q - p, r - p);
                ASSERT_LE(glm::dot(glm::dvec3(eye) - p, n), 0.0) << "a culled triangle faces the eye";
            }
        }
    }
    EXPECT_GT(static_cast<double>(culled), 0.05 * static_cast<double>(tested)); // and some are culled: measured 0.1
}

TEST(clusters, two_sided_meshes_are_never_culled_by_facing)
{
    const ClusteredMesh out = build_clusters(bumpy_sphere(20), true);
    ASSERT_GT(out.clusters.size(), 3u);
    for (const Cluster& c : out.clusters) EXPECT_GE(c.cone_cutoff, 1.0f);
}

} // namespace
} // namespace atrium
