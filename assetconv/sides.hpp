#pragma once
// Which meshes are seen from both sides.

#include "assetconv/triangles.hpp"

namespace atrium {

enum class TwoSided : std::uint8_t { automatic, on, off };

/// Share of a mesh's triangles that must wind as the file's normals say for the mesh to be one-sided.
inline constexpr double winding_agreement = 0.99;

/// The rule for a mesh of an opaque material: two-sided unless winding and the file's normals agree on at least
/// winding_agreement of its triangles. A triangle without normals agrees with nothing.
[[nodiscard]] bool winding_is_unreliable(const SourceScene& scene, const SourceMesh& mesh);

/// Reverses triangles whose winding contradicts the file's normals, in two-sided meshes with unreliable winding, so
/// that the side that the normals point to is lit as the front. Meshes stay two-sided; triangles without normals are
/// not changed. Counted as "winding-turned".
void turn_to_normals(SourceScene& scene, const std::filesystem::path& file, Warnings& warnings);

} // namespace atrium
