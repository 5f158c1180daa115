#pragma once
// The model while it is being built: parts (group x material), and the pen that draws into one of them.

#include "renderer/core/math.hpp"

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace atrium::courtyard {

struct Corner {
    vec3 position{0}, normal{0, 1, 0};
    vec2 uv{0};
};

/// Triangles of one group with one material. Fronts are counter-clockwise.
struct Part {
    std::string group, material;
    std::vector<Corner> corners;
    std::vector<std::uint32_t> indices;
};

class Model {
public:
    /// The part of that group and material; made when it is not there yet. The reference stays valid.
    Part& part(std::string_view group, std::string_view material);
    [[nodiscard]] const std::deque<Part>& parts() const { return parts_; }
    [[nodiscard]] std::size_t triangle_count() const;
    /// Removes what no triangle uses: corners, and parts that stayed empty.
    void tidy();

private:
    std::deque<Part> parts_;
};

/// Draws into a part through a placement. Shapes give positions and texture coordinates in metres of their own space;
/// the pen moves them, and divides texture coordinates by the size of one repeat of the material's texture.
class Pen {
public:
    /// @param placement rotation, translation and uniform scale, no mirroring
    /// @param least_chamfer smaller chamfers of boxes are not made, m
    Pen(Part& part, const mat4& placement, float tile = 1.0f, float least_chamfer = 0.0f);

    /// Moves the texture on what follows: no two slabs show the same piece of stone.
    void set_uv_offset(vec2 metres) { uv_offset_ = metres; }
    [[nodiscard]] float tile() const { return tile_; }
    [[nodiscard]] float least_chamfer() const { return least_chamfer_; }
    [[nodiscard]] Pen moved(const mat4& local) const;

    std::uint32_t add(const vec3& position, const vec3& normal, const vec2& uv);
    /// Wound so that its front agrees with its corners' normals, whatever the order given; nothing when it has no area.
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
    /// Joins two rows of `count` corners.
    void strip(std::uint32_t first_row, std::uint32_t second_row, std::uint32_t count);

private:
    Part* part_;
    mat4 placement_;
    float tile_, least_chamfer_;
    vec2 uv_offset_{0};
};

[[nodiscard]] mat4 moved_to(const vec3& position);
[[nodiscard]] mat4 turned(float radians_about_y);
/// Columns x, y, z must be orthonormal and right-handed.
[[nodiscard]] mat4 frame_of(const vec3& x, const vec3& y, const vec3& z, const vec3& origin);

} // namespace atrium::courtyard
