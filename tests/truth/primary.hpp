#pragma once
// What a camera sees, ray by ray: the known answer for the renderer's AOVs.

#include "renderer/core/image.hpp"
#include "renderer/scene/camera.hpp"
#include "tests/truth/mask.hpp"
#include "tests/truth/truth_scene.hpp"

#include <cstdint>
#include <vector>

namespace atrium::truth {

/// One ray through the centre of each pixel. Names, units and background values are those of the AOVs.
struct PrimaryBuffers {
    PrimaryBuffers(int width, int height);

    ImageF depth;            ///< m along the view axis; +inf
    ImageF position;         ///< world, m; 0
    ImageF geometric_normal; ///< unit, of the triangle's plane, turned towards the camera; 0
    ImageF shading_normal;   ///< unit, interpolated, turned over where the back is seen; without normal maps; 0
    ImageF uv;               ///< 2 channels; 0
    ImageF material, mesh;   ///< indices; -1
    std::vector<std::uint32_t> primitive; ///< triangle within its mesh; no_primitive
    Mask alpha;   ///< an alpha-tested or blended surface was hit, or a hole of one passed through on the way
    Mask surface; ///< anything was hit
};
inline constexpr std::uint32_t no_primitive = ~0u;

/// Pixel (i, j) looks through (i + 0.5, j + 0.5), j from the top; camera.fov is vertical. Backs of one-sided meshes are
/// passed through, and so is all that is nearer than `near` (m along the view axis), as a rasteriser clips it. The
/// camera's axes are reckoned here, not taken from the renderer. Runs on all of the jobs' threads; same result on any.
[[nodiscard]] PrimaryBuffers cast_primary(const TruthScene& scene, const Camera& camera, ivec2 size, double near = 0);

/// Pixels at silhouettes, edges and creases, where half a pixel decides what is seen: of the 3x3 around, two see
/// different meshes, or one lies off the centre's plane by more than 1 % of its depth, or normals differ by more than
/// 25 degrees. Then grown by one pixel.
[[nodiscard]] Mask silhouettes(const PrimaryBuffers& buffers);

} // namespace atrium::truth
