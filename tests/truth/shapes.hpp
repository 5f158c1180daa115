#pragma once
// Shapes for test scenes, and a few scenes made of them. World: +Y up, metres. All triangles are counter-clockwise seen
// from outside or from above.

#include "renderer/core/math.hpp"
#include "renderer/scene/bake_file.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace atrium::truth {

struct ShapeVertex {
    vec3 position{0};
    vec3 normal{0, 1, 0};  ///< unit
    vec3 tangent{1, 0, 0}; ///< unit, along +u; its bitangent cross(normal, tangent) runs up the image
    vec2 uv{0};            ///< (0,0) is the image's upper left
};

struct Shape {
    std::vector<ShapeVertex> vertices;
    std::vector<std::uint32_t> triangles;

    void add(const Shape& other);
};

/// A parallelogram that faces cross(edge_u, edge_v), cells.x by cells.y squares of two triangles. The image lies on it
/// once, upright: its lower left at `corner`, its upper left at corner + edge_v.
[[nodiscard]] Shape quad(const vec3& corner, const vec3& edge_u, const vec3& edge_v, ivec2 cells = {1, 1});
/// Horizontal, facing up, from -half to +half in x and z at height y; the image's top is at -z.
[[nodiscard]] Shape ground(float half, float y = 0, ivec2 cells = {1, 1});
[[nodiscard]] Shape box(const vec3& min, const vec3& max);
/// Smooth normals; `segments` around, half as many from pole to pole. Vertices lie on the sphere, so faces lie inside
/// by up to radius * (pi / segments)^2.
[[nodiscard]] Shape sphere(const vec3& centre, float radius, int segments = 64);

// Scenes. Ground 20 m half wide; each mesh has a material of its own, in the order in which they are named.

/// "floor".
[[nodiscard]] BakeData floor_scene();
/// "floor", and "wall": the plane x = 0 up to `height`, facing +x.
[[nodiscard]] BakeData wall_and_floor(float height = 20);
/// "floor", "wall" in x = 0 facing +x and "wall2" in z = 0 facing +z.
[[nodiscard]] BakeData corner_scene(float height = 20);
/// "floor", and "ceiling" at `height`, facing down.
[[nodiscard]] BakeData ceiling_scene(float height);
/// "floor", and "sphere" resting on it at the origin.
[[nodiscard]] BakeData sphere_on_floor(float radius, int segments = 128);
/// "floor", and "box" of the given half width on it, at the origin.
[[nodiscard]] BakeData box_on_floor(float half = 0.5f);
/// "floor", and "plate": horizontal at `height`, all of x > 0, one-sided from above: its edge is the line x = 0.
[[nodiscard]] BakeData plate_over_floor(float height);
/// "back": a wall in z = -1, and "leaf": a masked square from -1 to 1 in x and y in z = 0 facing +z, with the given
/// alphas (white, row 0 at the top) over it `repeat` times each way.
[[nodiscard]] BakeData masked_scene(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> alpha,
                                    bool clamp = false, float repeat = 1, float cutoff = 0.5f);

} // namespace atrium::truth
