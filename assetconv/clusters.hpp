#pragma once
// Order and culling data of one mesh: vertex cache, overdraw, clusters, vertex fetch (meshoptimizer).

#include "assetconv/vertices.hpp"

namespace atrium {

/// Small enough that a cluster is a fair unit of culling, large enough that a draw of one is worth its command.
inline constexpr std::size_t cluster_max_vertices = 128;
inline constexpr std::size_t cluster_max_triangles = 256;
/// How much clusters prefer triangles of one facing to a compact shape, 0..1: what cone culling lives on.
inline constexpr float cluster_cone_weight = 0.5f;

struct ClusteredMesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; ///< into vertices; cluster after cluster
    std::vector<Cluster> clusters;      ///< first_index counts from the mesh's own first index
};

/// Reorders a mesh for drawing. Clusters that face outwards come first, against overdraw (Sander et al. 2007, "Fast
/// Triangle Reordering for Vertex Locality and Reduced Overdraw"); inside each, triangles run in cache order; vertices
/// stand in the order of first use. Two-sided meshes get cones that never cull.
[[nodiscard]] ClusteredMesh build_clusters(IndexedMesh mesh, bool two_sided);

} // namespace atrium
