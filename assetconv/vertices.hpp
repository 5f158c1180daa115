#pragma once
// From corners to the vertex buffer: welding and tangents in one step.

#include "assetconv/triangles.hpp"
#include "renderer/scene/scene.hpp"

#include <vector>

namespace atrium {

struct IndexedMesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; ///< into vertices
};

/// How a material's maps lie on the surface: uv * scale + offset, in the file's coordinates (v up).
struct UvTransform {
    vec2 scale{1}, offset{0};
    bool operator==(const UvTransform&) const = default;
};

/// Welds corners of equal position, normal, uv and handedness into one vertex, with the angle-weighted mean of the
/// tangents around it. Mirrored uvs therefore split a seam. Triangles whose uv has no area take any tangent
/// perpendicular to the normal. The bitangent w cross(n, t) points up the image (towards smaller stored v, since v is
/// flipped here, once), as green-up normal maps want it. Source: Mikkelsen 2008, "Simulation of Wrinkled Surfaces
/// Revisited" (MikkTSpace).
[[nodiscard]] IndexedMesh build_vertices(const SourceScene& scene, const SourceMesh& mesh,
                                         const UvTransform& transform);

} // namespace atrium
