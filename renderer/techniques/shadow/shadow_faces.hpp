#pragma once
// The views from which a light's shadow map is drawn. Pure geometry.

#include "renderer/scene/camera.hpp"
#include "renderer/scene/light.hpp"
#include "shaders/shared/shadow.h"

#include <vector>

namespace atrium {

struct LightFaces {
    std::vector<shared::ShadowFace> faces; ///< in the order of the tiles, left to right
    bool perspective = true;
    float depth_scale = 0; ///< depth: near / z with perspective, 1 - z / reach without; m
    float near = 0;        ///< with perspective the same; without: where depth is 1, m along the light's axis
};

/// What a sun's cascades are fitted to.
struct CascadeFit {
    Camera camera;
    float aspect = 1;       ///< width / height
    int count = 4;          ///< 1 to shadow_max_faces
    std::uint32_t side = 1; ///< texels along a tile: centres move by whole texels
};

/// Distances at which cascades end, m: between uniform (lambda 0) and logarithmic (1). Source: Zhang et al. 2006,
/// "Parallel-Split Shadow Maps".
[[nodiscard]] std::vector<float> cascade_splits(float near, float far, int count, float lambda);

/// The sphere around a slice of the view between two distances: its centre's distance along the view axis, and its
/// radius, m. It does not change as the camera turns. `k2`: sum of the squared tangents of half the fields of view.
struct SliceSphere {
    double centre, radius;
};
[[nodiscard]] SliceSphere slice_sphere(double from, double to, double k2);

/// spot: one view, two degrees wider than its cone. point: the faces of a cube, +X -X +Y -Y -Z +Z. rect: those of the
/// half cube before it, right, left, up, down, front. sun: cascades; each but the last holds a slice of the view and
/// moves by whole texels, the last holds the whole scene and stays.
/// Around what is lit there is a guard band, so that filters find what stands outside and hides a part of the light:
/// `extent`, the light's radius, m, says how much.
[[nodiscard]] LightFaces light_faces(const Light& light, const Bounds& scene, const CascadeFit& fit, float extent);

} // namespace atrium
