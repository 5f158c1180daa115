#include "assetconv/courtyard/mesh.hpp"

#include <limits>
#include <utility>

namespace atrium::courtyard {
namespace {

constexpr float smallest_area = 1e-7f; // m2: a third of a square millimetre across, below what six decimals hold well

} // namespace

Part& Model::part(std::string_view group, std::string_view material)
{
    for (Part& p : parts_) {
        if (p.group == group && p.material == material) {
            return p;
        }
    }
    return parts_.emplace_back(Part{std::string(group), std::string(material), {}, {}});
}

std::size_t Model::triangle_count() const
{
    std::size_t count = 0;
    for (const Part& p : parts_) {
        count += p.indices.size() / 3;
    }
    return count;
}

void Model::tidy()
{
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    for (Part& p : parts_) {
        std::vector<std::uint32_t> place(p.corners.size(), unused);
        std::vector<Corner> kept;
        for (std::uint32_t& i : p.indices) {
            if (place[i] == unused) {
                place[i] = static_cast<std::uint32_t>(kept.size());
                kept.push_back(p.corners[i]);
            }
            i = place[i];
        }
        p.corners = std::move(kept);
    }
    std::erase_if(parts_, [](const Part& p) { return p.indices.empty(); });
}

Pen::Pen(Part& part, const mat4& placement, float tile, float least_chamfer)
    : part_(&part), placement_(placement), tile_(tile), least_chamfer_(least_chamfer)
{}

Pen Pen::moved(const mat4& local) const
{
    Pen pen = *this;
    pen.placement_ = placement_ * local;
    return pen;
}

std::uint32_t Pen::add(const vec3& position, const vec3& normal, const vec2& uv)
{
    const vec3 n = mat3(placement_) * normal;
    part_->corners.push_back({vec3(placement_ * vec4(position, 1)), n / glm::length(n), (uv + uv_offset_) / tile_});
    return static_cast<std::uint32_t>(part_->corners.size() - 1);
}

void Pen::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    const Corner &p = part_->corners[a], &q = part_->corners[b], &r = part_->corners[c];
    const vec3 across = glm::cross(q.position - p.position, r.position - p.position);
    if (0.5f * glm::length(across) < smallest_area) {
        return;
    }
    if (glm::dot(across, p.normal + q.normal + r.normal) < 0) {
        std::swap(b, c);
    }
    part_->indices.insert(part_->indices.end(), {a, b, c});
}

void Pen::quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    triangle(a, b, c);
    triangle(a, c, d);
}

void Pen::strip(std::uint32_t first_row, std::uint32_t second_row, std::uint32_t count)
{
    for (std::uint32_t i = 0; i + 1 < count; ++i) {
        quad(first_row + i, first_row + i + 1, second_row + i + 1, second_row + i);
    }
}

mat4 moved_to(const vec3& position)
{
    mat4 m(1);
    m[3] = vec4(position, 1);
    return m;
}

mat4 turned(float radians_about_y)
{
    const float c = std::cos(radians_about_y), s = std::sin(radians_about_y);
    return frame_of({c, 0, -s}, {0, 1, 0}, {s, 0, c}, vec3(0));
}

mat4 frame_of(const vec3& x, const vec3& y, const vec3& z, const vec3& origin)
{
    mat4 m(1);
    m[0] = vec4(x, 0);
    m[1] = vec4(y, 0);
    m[2] = vec4(z, 0);
    m[3] = vec4(origin, 1);
    return m;
}

} // namespace atrium::courtyard
