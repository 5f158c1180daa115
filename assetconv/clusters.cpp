#include "assetconv/clusters.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace atrium {
namespace {

using dvec3 = glm::dvec3;

/// Rounding of the test in 32-bit floats stays below these: relative to the radius, and absolute on the cosine.
constexpr double radius_margin = 1e-5;
constexpr double cutoff_margin = 1e-4;

struct Run {
    std::vector<std::uint32_t> indices;
    double facing = 0; ///< how far outwards it looks: larger is drawn earlier
};

std::vector<Run> cut_into_runs(const IndexedMesh& mesh)
{
    const auto* positions = &mesh.vertices[0].position.x;
    std::vector<std::uint32_t> order(mesh.indices.size());
    meshopt_optimizeVertexCache(order.data(), mesh.indices.data(), order.size(), mesh.vertices.size());
    const std::size_t bound = meshopt_buildMeshletsBound(order.size(), cluster_max_vertices, cluster_max_triangles);
    std::vector<meshopt_Meshlet> meshlets(bound);
    std::vector<unsigned int> vertices(bound * cluster_max_vertices);
    std::vector<unsigned char> triangles(bound * cluster_max_triangles * 3);
    meshlets.resize(meshopt_buildMeshlets(meshlets.data(), vertices.data(), triangles.data(), order.data(),
                                          order.size(), positions, mesh.vertices.size(), sizeof(Vertex),
                                          cluster_max_vertices, cluster_max_triangles, cluster_cone_weight));
    std::vector<Run> runs;
    runs.reserve(meshlets.size());
    for (const meshopt_Meshlet& m : meshlets) {
        // The cache order of a cluster is found on its local indices: the whole mesh's vertex count would cost each
        // time.
        std::vector<std::uint32_t> local(triangles.begin() + m.triangle_offset,
                                         triangles.begin() + m.triangle_offset + m.triangle_count * 3);
        meshopt_optimizeVertexCache(local.data(), local.data(), local.size(), m.vertex_count);
        for (std::uint32_t& i : local) i = vertices[m.vertex_offset + i];
        runs.push_back({std::move(local), 0});
    }
    return runs;
}

struct AreaSum {
    dvec3 centroid{0}, normal{0};
    double area = 0;
};

AreaSum sum_areas(const IndexedMesh& mesh, std::span<const std::uint32_t> indices)
{
    AreaSum sum;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const dvec3 a(mesh.vertices[indices[i]].position), b(mesh.vertices[indices[i + 1]].position),
            c(mesh.vertices[indices[i + 2]].position);
        const dvec3 n = glm::cross(b - a, c - a);
        const double area = glm::length(n);
        sum.centroid += (a + b + c) * (area / 3);
        sum.normal += n;
        sum.area += area;
    }
    if (sum.area > 0) sum.centroid /= sum.area;
    return sum;
}

void order_against_overdraw(const IndexedMesh& mesh, std::vector<Run>& runs)
{
    const dvec3 centre = sum_areas(mesh, mesh.indices).centroid;
    for (Run& run : runs) {
        const AreaSum sum = sum_areas(mesh, run.indices);
        const double length = glm::length(sum.normal);
        run.facing = length > 0 ? glm::dot(sum.centroid - centre, sum.normal / length) : 0;
    }
    std::stable_sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.facing > b.facing; });
}

/// meshoptimizer's sphere and cone, widened until they hold in spite of rounding.
Cluster bounds_of(const IndexedMesh& mesh, std::span<const std::uint32_t> indices, bool two_sided)
{
    const meshopt_Bounds b = meshopt_computeClusterBounds(indices.data(), indices.size(), &mesh.vertices[0].position.x,
                                                          mesh.vertices.size(), sizeof(Vertex));
    Cluster cluster;
    cluster.centre = {b.center[0], b.center[1], b.center[2]};
    double radius = 0, nearest_cosine = 1;
    const dvec3 axis(b.cone_axis[0], b.cone_axis[1], b.cone_axis[2]);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::array<dvec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = dvec3(mesh.vertices[indices[i + k]].position);
            radius = std::max(radius, glm::length(p[k] - dvec3(cluster.centre)));
        }
        const dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
        nearest_cosine = std::min(nearest_cosine, glm::dot(n, axis) / std::max(glm::length(n), 1e-300));
    }
    const double magnitude = glm::length(dvec3(cluster.centre)) + radius;
    cluster.radius = std::nextafter(static_cast<float>(radius + radius_margin * radius + 2.5e-7 * magnitude), INFINITY);
    if (two_sided || b.cone_cutoff >= 1 || nearest_cosine <= 0.1) return cluster;
    cluster.cone_axis = vec3(axis);
    const double cutoff = std::sqrt(1 - nearest_cosine * nearest_cosine) + cutoff_margin;
    cluster.cone_cutoff = std::min(1.0f, static_cast<float>(cutoff));
    return cluster;
}

} // namespace

ClusteredMesh build_clusters(IndexedMesh mesh, bool two_sided)
{
    std::vector<Run> runs = cut_into_runs(mesh);
    order_against_overdraw(mesh, runs);
    ClusteredMesh out;
    out.indices.reserve(mesh.indices.size());
    out.clusters.reserve(runs.size());
    for (const Run& run : runs) {
        Cluster cluster = bounds_of(mesh, run.indices, two_sided);
        cluster.first_index = static_cast<std::uint32_t>(out.indices.size());
        cluster.index_count = static_cast<std::uint32_t>(run.indices.size());
        out.clusters.push_back(cluster);
        out.indices.insert(out.indices.end(), run.indices.begin(), run.indices.end());
    }
    out.vertices.resize(mesh.vertices.size());
    const std::size_t used = meshopt_optimizeVertexFetch(out.vertices.data(), out.indices.data(), out.indices.size(),
                                                         mesh.vertices.data(), mesh.vertices.size(), sizeof(Vertex));
    out.vertices.resize(used);
    return out;
}

} // namespace atrium
