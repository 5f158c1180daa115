#pragma once
// Normals for corners that the file gives none.

#include "assetconv/triangles.hpp"

#include <optional>

namespace atrium {

/// Faces that meet at a larger angle than this keep an edge between them, where the file says nothing else.
inline constexpr float default_smooth_angle = 40.0f; // degrees

/// Fills every zero normal of the scene with the mean of the triangles' normals around the point, weighted by their
/// angles there. Which triangles take part: those of the same smoothing group; with smoothing off only the own one;
/// where the file says nothing, or always when `smooth_angle` (degrees) is given, those within that angle of the own
/// one. Source: Thürmer and Wüthrich 1998, "Computing Vertex Normals from Polygonal Facets".
void generate_normals(SourceScene& scene, std::optional<float> smooth_angle);

} // namespace atrium
