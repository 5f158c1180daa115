#pragma once
// The material half of a bake: MTL files, their images, and the plans made of them.

#include "assetconv/bake.hpp"

#include <vector>

namespace atrium {

struct MaterialSet {
    std::vector<MaterialPlan> plans;        ///< in MTL order, the default material last when it is needed
    std::vector<std::uint32_t> material_of; ///< for each of ObjFile::materials: index into plans
    std::uint32_t default_material = 0;     ///< for faces before any usemtl; a valid index only when it is needed
    ImageStore images;
};

/// Reads every library that the OBJ names, decodes the images of the materials that faces use, and applies the table.
[[nodiscard]] MaterialSet read_materials(const ObjFile& obj, const BakeOptions& options, Warnings& warnings,
                                         InputRecord& inputs);

/// Packs the planned textures, each different one once, builds their mips, and sets the materials' indices.
void bake_textures(const MaterialSet& set, const BakeOptions& options, BakeData& out);

} // namespace atrium
