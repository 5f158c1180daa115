#include "assetconv/triangles.hpp"

#include "assetconv/ear_clip.hpp"

#include <algorithm>
#include <cstring>
#include <unordered_map>
#include <unordered_set>

namespace atrium {
namespace {

/// A triangle flatter than this share of its longest side has lost its direction to 32-bit rounding.
constexpr double degenerate_height = 1e-7;

std::uint64_t mix(std::uint64_t h)
{
    h ^= h >> 31;
    h *= 0x9E3779B97F4A7C15ull;
    return h ^ h >> 29;
}

struct PointHash {
    std::size_t operator()(const vec3& p) const
    {
        std::array<std::uint32_t, 3> bits{};
        std::memcpy(bits.data(), &p, sizeof bits);
        return mix(mix(bits[0] | std::uint64_t{bits[1]} << 32) + bits[2]);
    }
};

vec3 to_world(const vec3& v, UpAxis up)
{
    // Adding zero turns -0 into +0, so that equal numbers have equal bits.
    return (up == UpAxis::z ? vec3(v.x, v.z, -v.y) : v) + vec3(0.0f);
}

/// Merges equal points; returns the merged index of each original one.
std::vector<std::int32_t> merge_points(const ObjFile& obj, float scale, UpAxis up, SourceScene& scene)
{
    std::unordered_map<vec3, std::int32_t, PointHash> known;
    known.reserve(obj.positions.size());
    std::vector<std::int32_t> merged;
    merged.reserve(obj.positions.size());
    for (const vec3& p : obj.positions) {
        const vec3 world = to_world(p * scale, up);
        const auto [at, added] = known.try_emplace(world, static_cast<std::int32_t>(scene.positions.size()));
        if (added) scene.positions.push_back(world);
        merged.push_back(at->second);
    }
    return merged;
}

/// Unit normals of the world; zero for those without a direction.
std::vector<vec3> world_normals(const ObjFile& obj, UpAxis up, Warnings& warnings)
{
    std::vector<vec3> normals;
    normals.reserve(obj.normals.size());
    std::uint64_t bad = 0;
    for (const vec3& n : obj.normals) {
        const glm::dvec3 wide(n);
        const double length = glm::length(wide);
        const bool good = length > 1e-12;
        bad += good ? 0 : 1;
        normals.push_back(good ? to_world(vec3(wide / length), up) : vec3(0));
    }
    if (bad > 0) warnings.add("normal-bad", obj.path.filename().string(), bad);
    return normals;
}

bool is_degenerate(const SourceScene& scene, const SourceTriangle& t)
{
    const auto& c = t.corners;
    if (c[0].position == c[1].position || c[1].position == c[2].position || c[2].position == c[0].position) return true;
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 a(scene.positions[static_cast<std::size_t>(c[i].position)]);
        const glm::dvec3 b(scene.positions[static_cast<std::size_t>(c[(i + 1) % 3].position)]);
        longest = std::max(longest, glm::dot(b - a, b - a));
    }
    return glm::length(area_normal(scene, t)) <= degenerate_height * longest;
}

class Builder {
public:
    Builder(const ObjFile& obj, float scale, UpAxis up, Warnings& warnings)
        : obj_(obj), warnings_(warnings), merged_(merge_points(obj, scale, up, scene_)),
          normals_(world_normals(obj, up, warnings))
    {
        scene_.uvs = obj.uvs;
    }

    void add(const ObjFace& face, std::uint32_t material)
    {
        if (face.corner_count > max_polygon_corners)
            return warnings_.add("polygon-too-large", place(obj_.path, face.line));
        SourceMesh& mesh = find_mesh(face, material);
        if (face.corner_count == 3) return add_triangle(mesh, face, {0, 1, 2});
        polygon_.clear();
        for (std::uint32_t i = 0; i < face.corner_count; ++i) {
            const auto position = obj_.corners[face.first_corner + i].position;
            polygon_.push_back(obj_.positions[static_cast<std::size_t>(position)]);
        }
        const EarClipping cut = clip_ears(polygon_);
        if (!cut.simple) warnings_.add("polygon-not-simple", place(obj_.path, face.line));
        for (const auto& t : cut.triangles) add_triangle(mesh, face, t);
    }

    SourceScene take()
    {
        std::erase_if(scene_.meshes, [](const SourceMesh& m) { return m.triangles.empty(); });
        return std::move(scene_);
    }

private:
    SourceMesh& find_mesh(const ObjFace& face, std::uint32_t material)
    {
        const std::uint64_t key = std::uint64_t{face.group} << 32 | material;
        const auto [at, added] = mesh_of_.try_emplace(key, scene_.meshes.size());
        if (added) scene_.meshes.push_back({obj_.groups[face.group].name, material, {}, false});
        return scene_.meshes[at->second];
    }

    void add_triangle(SourceMesh& mesh, const ObjFace& face, const std::array<std::uint32_t, 3>& corners)
    {
        SourceTriangle t;
        t.smoothing = face.smoothing;
        t.line = face.line;
        for (std::size_t i = 0; i < 3; ++i) {
            ObjCorner c = obj_.corners[face.first_corner + corners[i]];
            c.position = merged_[static_cast<std::size_t>(c.position)];
            if (c.normal >= 0) t.normals[i] = normals_[static_cast<std::size_t>(c.normal)];
            t.corners[i] = c;
        }
        if (is_degenerate(scene_, t))
            warnings_.add("face-degenerate", place(obj_.path, face.line));
        else
            mesh.triangles.push_back(t);
    }

    const ObjFile& obj_;
    Warnings& warnings_;
    SourceScene scene_;
    std::vector<std::int32_t> merged_;
    std::vector<vec3> normals_;
    std::unordered_map<std::uint64_t, std::size_t> mesh_of_;
    std::vector<vec3> polygon_;
};

/// Three position indices, turned so that the smallest comes first; sorted when winding does not matter.
struct TriangleKey {
    std::array<std::int32_t, 3> p;
    bool operator==(const TriangleKey&) const = default;
};
struct TriangleKeyHash {
    std::size_t operator()(const TriangleKey& k) const
    {
        const auto word = [&](std::size_t i) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(k.p[i])); };
        return mix(mix(word(0) | word(1) << 32) + word(2));
    }
};

TriangleKey key_of(const SourceTriangle& t, bool any_winding)
{
    TriangleKey k{{t.corners[0].position, t.corners[1].position, t.corners[2].position}};
    if (any_winding)
        std::sort(k.p.begin(), k.p.end());
    else
        std::rotate(k.p.begin(), std::min_element(k.p.begin(), k.p.end()), k.p.end());
    return k;
}

void drop_repeated(SourceMesh& mesh, bool any_winding, const std::filesystem::path& file, Warnings& warnings)
{
    std::unordered_set<TriangleKey, TriangleKeyHash> seen;
    seen.reserve(mesh.triangles.size());
    std::erase_if(mesh.triangles, [&](const SourceTriangle& t) {
        const bool repeated = !seen.insert(key_of(t, any_winding)).second;
        if (repeated) warnings.add("face-duplicate", place(file, t.line));
        return repeated;
    });
}

} // namespace

glm::dvec3 area_normal(const SourceScene& scene, const SourceTriangle& t)
{
    const auto at = [&](std::size_t i) {
        return glm::dvec3(scene.positions[static_cast<std::size_t>(t.corners[i].position)]);
    };
    return glm::cross(at(1) - at(0), at(2) - at(0));
}

SourceScene build_triangles(const ObjFile& obj, const std::vector<std::uint32_t>& material_of,
                            std::uint32_t default_material, float scale, UpAxis up, Warnings& warnings)
{
    Builder builder(obj, scale, up, warnings);
    for (const ObjFace& face : obj.faces) {
        builder.add(face, face.material < 0 ? default_material : material_of[static_cast<std::size_t>(face.material)]);
    }
    return builder.take();
}

void drop_duplicates(SourceScene& scene, const std::filesystem::path& file, Warnings& warnings)
{
    for (SourceMesh& mesh : scene.meshes) drop_repeated(mesh, false, file, warnings);
}

void drop_reversed_duplicates(SourceScene& scene, const std::filesystem::path& file, Warnings& warnings)
{
    for (SourceMesh& mesh : scene.meshes) {
        if (mesh.two_sided) drop_repeated(mesh, true, file, warnings);
    }
}

} // namespace atrium
