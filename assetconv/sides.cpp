#include "assetconv/sides.hpp"

#include <algorithm>

namespace atrium {

bool winding_is_unreliable(const SourceScene& scene, const SourceMesh& mesh)
{
    const auto agree = std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const SourceTriangle& t) {
        const glm::dvec3 normal(t.normals[0] + t.normals[1] + t.normals[2]);
        return glm::dot(area_normal(scene, t), normal) > 0;
    });
    return static_cast<double>(agree) < winding_agreement * static_cast<double>(mesh.triangles.size());
}

} // namespace atrium
