#pragma once
// The geometry half of a bake.

#include "assetconv/bake_materials.hpp"

namespace atrium {

/// Meshes, clusters, vertices and indices of the OBJ's faces, in file order.
/// Throws Error(input) when no triangle is left to draw.
void bake_meshes(const ObjFile& obj, const MaterialSet& set, const BakeOptions& options, BakeData& out,
                 Warnings& warnings);

} // namespace atrium
