#pragma once
// The intermediate mesh: triangles of one OBJ group x material, with positions in the world.

#include "assetconv/obj.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace atrium {

struct SourceTriangle {
    std::array<ObjCorner, 3> corners; ///< position: into SourceScene::positions, equal points share an index
    std::array<vec3, 3> normals{vec3(0), vec3(0), vec3(0)}; ///< unit, world; zero where the file gives none
    std::uint32_t smoothing = smoothing_unset;
    std::uint32_t line = 0;
};

struct SourceMesh {
    std::string name;
    std::uint32_t material = 0;
    std::vector<SourceTriangle> triangles;
    bool two_sided = false;
};

struct SourceScene {
    std::vector<vec3> positions; ///< world, metres; no two alike
    std::vector<vec2> uvs;       ///< v up
    std::vector<SourceMesh> meshes;
};

enum class UpAxis : std::uint8_t { y, z };

/// Triangulates, scales and turns an OBJ's faces and sorts them into meshes, one per group x material in order of
/// first appearance. `material_of[i]` is the scene's material for ObjFile::materials[i]; `default_material` is for
/// faces before any usemtl. Drops and counts triangles without area.
[[nodiscard]] SourceScene build_triangles(const ObjFile& obj, const std::vector<std::uint32_t>& material_of,
                                          std::uint32_t default_material, float scale, UpAxis up, Warnings& warnings);

/// Drops triangles that a mesh holds twice, wound the same way.
void drop_duplicates(SourceScene& scene, const std::filesystem::path& file, Warnings& warnings);
/// The same for triangles of two-sided meshes that differ in winding only.
void drop_reversed_duplicates(SourceScene& scene, const std::filesystem::path& file, Warnings& warnings);

/// Twice the area times the unit normal, counter-clockwise seen from outside. In double, so that slivers keep a
/// direction.
[[nodiscard]] glm::dvec3 area_normal(const SourceScene& scene, const SourceTriangle& t);

} // namespace atrium
