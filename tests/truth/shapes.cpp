#include "tests/truth/shapes.hpp"

#include "tests/truth/scene_builder.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::truth {
namespace {

constexpr float ground_half = 20;

struct Part {
    const char* name;
    vec3 base_color;
    Shape shape;
};

BakeData scene_of(std::span<const Part> parts)
{
    SceneBuilder builder;
    for (const Part& p : parts) builder.add_mesh(p.name, builder.add_material(p.name, p.base_color), p.shape);
    return builder.finish();
}

const vec3 grey(0.5f), red(0.6f, 0.1f, 0.1f), green(0.1f, 0.5f, 0.1f);

Shape wall_x(float height)
{
    return quad({0, 0, ground_half}, {0, 0, -2 * ground_half}, {0, height, 0});
}

} // namespace

void Shape::add(const Shape& other)
{
    const auto base = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const std::uint32_t i : other.triangles) triangles.push_back(base + i);
}

Shape quad(const vec3& corner, const vec3& edge_u, const vec3& edge_v, ivec2 cells)
{
    const vec3 normal = glm::normalize(glm::cross(edge_u, edge_v)), tangent = glm::normalize(edge_u);
    Shape s;
    for (int j = 0; j <= cells.y; ++j) {
        for (int i = 0; i <= cells.x; ++i) {
            const float a = static_cast<float>(i) / static_cast<float>(cells.x);
            const float b = static_cast<float>(j) / static_cast<float>(cells.y);
            s.vertices.push_back({corner + a * edge_u + b * edge_v, normal, tangent, {a, 1 - b}});
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells.x + 1) + i); };
    for (int j = 0; j < cells.y; ++j) {
        for (int i = 0; i < cells.x; ++i) {
            s.triangles.insert(s.triangles.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1), //
                                                   at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return s;
}

Shape ground(float half, float y, ivec2 cells)
{
    return quad({-half, y, half}, {2 * half, 0, 0}, {0, 0, -2 * half}, cells);
}

Shape box(const vec3& min, const vec3& max)
{
    const vec3 e = max - min, x(e.x, 0, 0), y(0, e.y, 0), z(0, 0, e.z);
    Shape s;
    s.add(quad(min + z, x, y));      // +z
    s.add(quad(min + x, -x, y));     // -z
    s.add(quad(min + x + z, -z, y)); // +x
    s.add(quad(min, z, y));          // -x
    s.add(quad(min + y + z, x, -z)); // +y
    s.add(quad(min, x, z));          // -y
    return s;
}

Shape sphere(const vec3& centre, float radius, int segments)
{
    const int rings = std::max(2, segments / 2);
    Shape s;
    for (int j = 0; j <= rings; ++j) {
        for (int i = 0; i <= segments; ++i) {
            const double phi = 2 * 3.14159265358979323846 * i / segments, theta = 3.14159265358979323846 * j / rings;
            const glm::dvec3 n(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
            const vec3 tangent(glm::dvec3(std::cos(phi), 0, -std::sin(phi)));
            s.vertices.push_back({centre + radius * vec3(n),
                                  vec3(n),
                                  tangent,
                                  {static_cast<float>(i) / static_cast<float>(segments),
                                   static_cast<float>(j) / static_cast<float>(rings)}});
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (segments + 1) + i); };
    for (int j = 0; j < rings; ++j) {
        for (int i = 0; i < segments; ++i) {
            if (j > 0) s.triangles.insert(s.triangles.end(), {at(i, j), at(i + 1, j + 1), at(i + 1, j)});
            if (j + 1 < rings) s.triangles.insert(s.triangles.end(), {at(i, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    }
    return s;
}

BakeData floor_scene()
{
    return scene_of({{Part{"floor", grey, ground(ground_half)}}});
}

BakeData wall_and_floor(float height)
{
    const Part parts[]{{"floor", grey, ground(ground_half)}, {"wall", red, wall_x(height)}};
    return scene_of(parts);
}

BakeData corner_scene(float height)
{
    const Part parts[]{{"floor", grey, ground(ground_half)},
                       {"wall", red, wall_x(height)},
                       {"wall2", green, quad({-ground_half, 0, 0}, {2 * ground_half, 0, 0}, {0, height, 0})}};
    return scene_of(parts);
}

BakeData ceiling_scene(float height)
{
    const Part parts[]{
        {"floor", grey, ground(ground_half)},
        {"ceiling", red, quad({-ground_half, height, -ground_half}, {2 * ground_half, 0, 0}, {0, 0, 2 * ground_half})}};
    return scene_of(parts);
}

BakeData sphere_on_floor(float radius, int segments)
{
    const Part parts[]{{"floor", grey, ground(ground_half)}, {"sphere", red, sphere({0, radius, 0}, radius, segments)}};
    return scene_of(parts);
}

BakeData box_on_floor(float half)
{
    const Part parts[]{{"floor", grey, ground(ground_half)},
                       {"box", red, box({-half, 0, -half}, {half, 2 * half, half})}};
    return scene_of(parts);
}

BakeData plate_over_floor(float height)
{
    const Part parts[]{{"floor", grey, ground(ground_half)},
                       {"plate", red, quad({0, height, ground_half}, {ground_half, 0, 0}, {0, 0, -2 * ground_half})}};
    return scene_of(parts);
}

BakeData masked_scene(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> alpha, bool clamp,
                      float repeat, float cutoff)
{
    SceneBuilder builder;
    builder.add_mesh("back", builder.add_material("back", grey), quad({-5, -5, -1}, {10, 0, 0}, {0, 10, 0}));
    Material leaf;
    leaf.name = "leaf";
    leaf.cls = MaterialClass::masked;
    leaf.two_sided = true;
    leaf.base_color = green;
    leaf.alpha_cutoff = cutoff;
    leaf.base_color_texture = builder.add_alpha_texture(width, height, alpha, clamp);
    Shape square = quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    for (ShapeVertex& v : square.vertices) v.uv *= repeat;
    builder.add_mesh("leaf", builder.add_material(leaf), square);
    return builder.finish();
}

} // namespace atrium::truth
