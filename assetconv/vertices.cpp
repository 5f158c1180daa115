#include "assetconv/vertices.hpp"

#include "renderer/scene/vertex_packing.hpp"

#include <cmath>
#include <unordered_map>

namespace atrium {
namespace {

struct VertexKey {
    std::int32_t position;
    std::uint32_t normal; ///< packed
    float u, v;
    bool mirrored;
    bool operator==(const VertexKey&) const = default;
};

struct VertexKeyHash {
    std::size_t operator()(const VertexKey& k) const
    {
        std::uint64_t h = static_cast<std::uint32_t>(k.position) | std::uint64_t{k.normal} << 32;
        h = (h ^ h >> 29) * 0xBF58476D1CE4E5B9ull;
        h ^= std::uint64_t{std::hash<float>{}(k.u)} * 31 + std::hash<float>{}(k.v) + (k.mirrored ? 0x9E37u : 0u);
        h = (h ^ h >> 32) * 0x94D049BB133111EBull;
        return h ^ h >> 31;
    }
};

/// A triangle's own tangent frame in uv space.
struct UvFrame {
    vec3 tangent{0}; ///< along +u, any length
    bool mirrored = false;
    bool usable = false;
};

UvFrame frame_of(const std::array<vec3, 3>& p, const std::array<vec2, 3>& uv)
{
    const glm::dvec2 d1 = glm::dvec2(uv[1]) - glm::dvec2(uv[0]), d2 = glm::dvec2(uv[2]) - glm::dvec2(uv[0]);
    const glm::dvec3 e1 = glm::dvec3(p[1]) - glm::dvec3(p[0]), e2 = glm::dvec3(p[2]) - glm::dvec3(p[0]);
    const double det = d1.x * d2.y - d1.y * d2.x;
    const double scale = (glm::dot(d1, d1) + glm::dot(d2, d2));
    UvFrame frame;
    frame.mirrored = det < 0;
    if (!(std::abs(det) > 1e-12 * scale)) return frame; // also when anything is not finite
    const glm::dvec3 t = (e1 * d2.y - e2 * d1.y) * (det < 0 ? -1.0 : 1.0);
    const double length = glm::length(t);
    if (!(length > 0) || !std::isfinite(length)) return frame;
    frame.tangent = vec3(t / length);
    frame.usable = true;
    return frame;
}

vec3 any_perpendicular(const vec3& n)
{
    const vec3 axis = std::abs(n.x) < 0.57f ? vec3(1, 0, 0) : std::abs(n.y) < 0.57f ? vec3(0, 1, 0) : vec3(0, 0, 1);
    return glm::normalize(axis - n * glm::dot(n, axis));
}

class Welder {
public:
    Welder(const SourceScene& scene, const SourceMesh& mesh, const UvTransform& transform)
        : scene_(scene), mesh_(mesh), transform_(transform)
    {
        const std::size_t corners = mesh.triangles.size() * 3;
        out_.indices.resize(corners);
        known_.reserve(corners / 2);
    }

    IndexedMesh run()
    {
        std::vector<std::size_t> without_frame;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (!add(t, false)) without_frame.push_back(t);
        }
        // Last, so that they join the vertices of neighbours that have a frame.
        for (const std::size_t t : without_frame) add(t, true);
        for (std::size_t i = 0; i < out_.vertices.size(); ++i) {
            const vec3& sum = tangents_[i];
            const float length = glm::length(sum);
            const vec3 n = unpack_normal(out_.vertices[i].normal);
            const vec3 t = length > 1e-6f ? sum / length : any_perpendicular(n);
            out_.vertices[i].tangent = pack_tangent(t, mirrored_[i] ? -1.0f : 1.0f);
        }
        return std::move(out_);
    }

private:
    [[nodiscard]] vec2 uv_of(const ObjCorner& c) const
    {
        if (c.uv < 0) return vec2(0);
        const vec2 uv = scene_.uvs[static_cast<std::size_t>(c.uv)] * transform_.scale + transform_.offset;
        return std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : vec2(0);
    }

    /// False when the triangle has no frame of its own and `without_frame` does not say to add it nevertheless.
    bool add(std::size_t index, bool without_frame)
    {
        const SourceTriangle& t = mesh_.triangles[index];
        std::array<vec3, 3> p;
        std::array<vec2, 3> uv;
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = scene_.positions[static_cast<std::size_t>(t.corners[i].position)];
            uv[i] = uv_of(t.corners[i]);
        }
        const UvFrame frame = frame_of(p, uv);
        if (!frame.usable && !without_frame) return false;
        for (std::size_t i = 0; i < 3; ++i) {
            VertexKey key{t.corners[i].position, pack_normal(t.normals[i]), uv[i].x + 0.0f, 1.0f - uv[i].y + 0.0f,
                          frame.usable && frame.mirrored};
            if (!frame.usable) key.mirrored = !known_.contains(key) && known_with_other_hand(key);
            const std::uint32_t vertex = find_or_add(key, p[i]);
            out_.indices[index * 3 + i] = vertex;
            if (frame.usable)
                accumulate(vertex, t.normals[i], frame.tangent, p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
        }
        return true;
    }

    [[nodiscard]] bool known_with_other_hand(VertexKey key) const
    {
        key.mirrored = true;
        return known_.contains(key);
    }

    std::uint32_t find_or_add(const VertexKey& key, const vec3& position)
    {
        const auto [at, added] = known_.try_emplace(key, static_cast<std::uint32_t>(out_.vertices.size()));
        if (added) {
            out_.vertices.push_back({position, key.normal, 0, {key.u, key.v}});
            tangents_.emplace_back(0);
            mirrored_.push_back(key.mirrored);
        }
        return at->second;
    }

    void accumulate(std::uint32_t vertex, const vec3& n, const vec3& t, const vec3& a, const vec3& b)
    {
        const vec3 in_plane = t - n * glm::dot(n, t);
        const float length = glm::length(in_plane);
        if (length < 1e-6f) return;
        const vec3 pa = a - n * glm::dot(n, a), pb = b - n * glm::dot(n, b); // angle as the vertex's plane sees it
        const float angle = std::atan2(glm::length(glm::cross(pa, pb)), glm::dot(pa, pb));
        tangents_[vertex] += in_plane / length * angle;
    }

    const SourceScene& scene_;
    const SourceMesh& mesh_;
    const UvTransform& transform_;
    IndexedMesh out_;
    std::vector<vec3> tangents_;
    std::vector<bool> mirrored_;
    std::unordered_map<VertexKey, std::uint32_t, VertexKeyHash> known_;
};

} // namespace

IndexedMesh build_vertices(const SourceScene& scene, const SourceMesh& mesh, const UvTransform& transform)
{
    return Welder(scene, mesh, transform).run();
}

} // namespace atrium
