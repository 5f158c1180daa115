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

/// Turns the triangles of two-sided meshes with unreliable winding that wind against the file's normals, so that the
/// side that is lit as front is where the normals point. Meshes stay two-sided, and triangles without normals stay as
/// they are. Counted as "winding-turned".
void turn_to_normals(SourceScene& scene, const std::filesystem::path& file, Warnings& warnings);

} // namespace atrium
