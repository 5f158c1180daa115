#pragma once
// A bake behind Embree: what tests ask when they want to know where a ray really ends. Never part of the product; it
// shares nothing with the renderer but the baked file.

#include "renderer/scene/bake_file.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

namespace atrium::truth {

using glm::dvec2;
using glm::dvec3;

/// World space, m. Distances count in lengths of `direction`, which need not be 1.
struct Ray {
    dvec3 origin{0};
    dvec3 direction{0, 0, -1};
    double near = 0;
    double far = std::numeric_limits<double>::infinity();
};

/// Where a ray meets a surface. Reckoned anew in doubles from the baked triangle that Embree found.
struct Hit {
    double distance = 0;    ///< in lengths of the ray's direction
    dvec3 position{0};      ///< world, m
    dvec3 plane_normal{0};  ///< unit, of the triangle's plane, on the side that its winding faces
    dvec3 vertex_normal{0}; ///< unit, interpolated between the vertices
    dvec2 uv{0};
    bool front = true; ///< the ray came from the side that the winding faces
    std::uint32_t mesh = 0, material = 0;
    std::uint32_t primitive = 0; ///< triangle within the mesh
    bool alpha = false;          ///< a masked or blended surface was met here or, as a hole, on the way here
};

/// What a ray does to the back of a one-sided triangle.
enum class Facing {
    cull, ///< passes through, as a rasteriser with back-face culling lets it: primary visibility
    any,  ///< is stopped: shadow casters are never culled by facing
};

/// Masked materials have holes where opacity x bilinear alpha of mip 0 is below the cutoff; blended ones are solid.
/// A mesh is two-sided when it or its material says so. The bake must outlive the scene. All members are thread-safe.
class TruthScene {
public:
    /// Throws Error(input) where an index leaves the bake's vertices, Error(environment) where Embree fails.
    explicit TruthScene(const BakeFile& bake);
    ~TruthScene();
    TruthScene(const TruthScene&) = delete;
    TruthScene& operator=(const TruthScene&) = delete;

    [[nodiscard]] std::optional<Hit> first_hit(const Ray& ray, Facing facing) const;
    /// Whether anything stands between near and far; never culls.
    [[nodiscard]] bool occluded(const Ray& ray) const;
    [[nodiscard]] const Scene& scene() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace atrium::truth
