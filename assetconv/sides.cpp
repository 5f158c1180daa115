#include "assetconv/sides.hpp"

#include <algorithm>
#include <utility>

namespace atrium {
namespace {

/// Agreement of winding and the file's normals: positive if they agree, negative if they are opposite, 0 without
/// normals.
double agreement(const SourceScene& scene, const SourceTriangle& t)
{
    return glm::dot(area_normal(scene, t), glm::dvec3(t.normals[0] + t.normals[1] + t.normals[2]));
}

void turn(SourceTriangle& t)
{
    std::swap(t.corners[1], t.corners[2]);
    std::swap(t.normals[1], t.normals[2]);
}

} // namespace

bool winding_is_unreliable(const SourceScene& scene, const SourceMesh& mesh)
{
    const auto agree = std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                     [&](const SourceTriangle& t) { return agreement(scene, t) > 0; });
    return static_cast<double>(agree) < winding_agreement * static_cast<double>(mesh.triangles.size());
}

void turn_to_normals(SourceScene& scene, const std::filesystem::path& file, Warnings& warnings)
{
    for (SourceMesh& mesh : scene.meshes) {
        if (!mesh.two_sided || !winding_is_unreliable(scene, mesh)) continue;
        for (SourceTriangle& t : mesh.triangles) {
            if (agreement(scene, t) >= 0) continue;
            turn(t);
            warnings.add("winding-turned", place(file, t.line));
        }
    }
}

} // namespace atrium
