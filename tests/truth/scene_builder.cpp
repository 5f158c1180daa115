#include "tests/truth/scene_builder.hpp"

#include "renderer/core/error.hpp"
#include "renderer/scene/vertex_packing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace atrium::truth {
namespace {

constexpr std::size_t cluster_triangles = 64; ///< small, so that small scenes have several

using glm::dvec3;

dvec3 triangle_normal(const std::vector<Vertex>& vertices, std::span<const std::uint32_t> t)
{
    const dvec3 a(vertices[t[0]].position);
    const dvec3 n = glm::cross(dvec3(vertices[t[1]].position) - a, dvec3(vertices[t[2]].position) - a);
    const double length = glm::length(n);
    return length > 0 ? n / length : n;
}

/// Sphere around the middle of the box; cone of the normals by meshoptimizer's rule, left open where they spread.
Cluster cluster_of(const std::vector<Vertex>& vertices, std::span<const std::uint32_t> indices, bool two_sided)
{
    Bounds box;
    for (const std::uint32_t i : indices) box.add(vertices[i].position);
    Cluster c;
    c.centre = box.centre();
    for (const std::uint32_t i : indices) c.radius = std::max(c.radius, glm::length(vertices[i].position - c.centre));
    c.radius = c.radius * 1.0001f + 1e-6f; // rounding
    if (two_sided) return c;

    dvec3 sum(0);
    for (std::size_t i = 0; i < indices.size(); i += 3) sum += triangle_normal(vertices, indices.subspan(i, 3));
    if (glm::length(sum) < 1e-6) return c;
    const dvec3 axis = glm::normalize(sum);
    double spread = 1;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        spread = std::min(spread, glm::dot(axis, triangle_normal(vertices, indices.subspan(i, 3))));
    }
    if (spread <= 0.1) return c;
    c.cone_axis = vec3(axis);
    c.cone_cutoff = static_cast<float>(std::sqrt(1 - spread * spread) + 1e-4);
    return c;
}

using Level = std::vector<std::uint8_t>; ///< RGBA

Level half_of(const Level& from, std::uint32_t width, std::uint32_t height)
{
    const std::uint32_t w = std::max(1u, width / 2), h = std::max(1u, height / 2);
    Level out(std::size_t{w} * h * 4);
    for (std::uint32_t y = 0; y < h; ++y) {
        for (std::uint32_t x = 0; x < w; ++x) {
            for (std::uint32_t c = 0; c < 4; ++c) {
                std::uint32_t sum = 2;
                for (std::uint32_t k = 0; k < 4; ++k) {
                    const std::uint32_t u = std::min(width - 1, 2 * x + k % 2), v = std::min(height - 1, 2 * y + k / 2);
                    sum += from[(std::size_t{v} * width + u) * 4 + c];
                }
                out[(std::size_t{y} * w + x) * 4 + c] = static_cast<std::uint8_t>(sum / 4);
            }
        }
    }
    return out;
}

} // namespace

std::uint32_t SceneBuilder::add_material(const Material& material)
{
    data_.scene.materials.push_back(material);
    return static_cast<std::uint32_t>(data_.scene.materials.size() - 1);
}

std::uint32_t SceneBuilder::add_material(const std::string& name, const vec3& base_color)
{
    Material material;
    material.name = name;
    material.base_color = base_color;
    return add_material(material);
}

std::int32_t SceneBuilder::add_texture(const std::string& file, std::uint32_t width, std::uint32_t height,
                                       std::span<const std::uint8_t> rgba, TextureFormat format, bool clamp)
{
    Texture t;
    t.file = file;
    t.width = width;
    t.height = height;
    t.format = format;
    t.clamp = clamp;
    for (std::uint32_t size = std::max(width, height); size > 0; size /= 2) ++t.mips;
    const auto offsets = mip_offsets(format, width, height, t.mips);
    t.offset = data_.texels.size(); // each texture's size is a multiple of the alignment
    t.size = offsets.back();
    data_.texels.resize(t.offset + t.size);
    Level level(rgba.begin(), rgba.end());
    for (std::uint32_t mip = 0; mip < t.mips; ++mip) {
        std::transform(level.begin(), level.end(),
                       data_.texels.begin() + static_cast<std::ptrdiff_t>(t.offset + offsets[mip]),
                       [](std::uint8_t b) { return std::byte{b}; });
        level = half_of(level, std::max(1u, width >> mip), std::max(1u, height >> mip));
    }
    data_.scene.textures.push_back(t);
    return static_cast<std::int32_t>(data_.scene.textures.size() - 1);
}

std::int32_t SceneBuilder::add_alpha_texture(std::uint32_t width, std::uint32_t height,
                                             std::span<const std::uint8_t> alpha, bool clamp)
{
    Level rgba(std::size_t{width} * height * 4, 255);
    for (std::size_t i = 0; i < alpha.size(); ++i) rgba[4 * i + 3] = alpha[i];
    return add_texture("alpha" + std::to_string(data_.scene.textures.size()), width, height, rgba,
                       TextureFormat::rgba8_srgb, clamp);
}

std::uint32_t SceneBuilder::add_mesh(const std::string& name, std::uint32_t material, const Shape& shape)
{
    const Material& m = data_.scene.materials.at(material);
    Mesh mesh;
    mesh.name = name;
    mesh.material = material;
    mesh.two_sided = m.two_sided || m.cls == MaterialClass::masked || m.cls == MaterialClass::blended;
    mesh.first_vertex = static_cast<std::uint32_t>(data_.vertices.size());
    mesh.vertex_count = static_cast<std::uint32_t>(shape.vertices.size());
    mesh.first_index = static_cast<std::uint32_t>(data_.indices.size());
    mesh.index_count = static_cast<std::uint32_t>(shape.triangles.size());
    mesh.first_cluster = static_cast<std::uint32_t>(data_.scene.clusters.size());
    for (const ShapeVertex& v : shape.vertices) {
        data_.vertices.push_back({v.position, pack_normal(v.normal), pack_tangent(v.tangent, 1.0f), v.uv});
        mesh.bounds.add(v.position);
    }
    for (const std::uint32_t i : shape.triangles) data_.indices.push_back(mesh.first_vertex + i);
    const auto indices = std::span<const std::uint32_t>(data_.indices).subspan(mesh.first_index);
    for (std::size_t i = 0; i < indices.size(); i += 3 * cluster_triangles) {
        const auto run = indices.subspan(i, std::min(3 * cluster_triangles, indices.size() - i));
        Cluster cluster = cluster_of(data_.vertices, run, mesh.two_sided);
        cluster.first_index = mesh.first_index + static_cast<std::uint32_t>(i);
        cluster.index_count = static_cast<std::uint32_t>(run.size());
        data_.scene.clusters.push_back(cluster);
        ++mesh.cluster_count;
    }
    data_.scene.meshes.push_back(mesh);
    return static_cast<std::uint32_t>(data_.scene.meshes.size() - 1);
}

BakeData SceneBuilder::finish() const
{
    BakeData data = data_;
    data.scene.source = "shapes.obj";
    data.scene.vertex_count = data.vertices.size();
    data.scene.index_count = data.indices.size();
    for (const Mesh& mesh : data.scene.meshes) data.scene.bounds.add(mesh.bounds);
    return data;
}

TempBake::TempBake(const BakeData& data)
{
    std::string name = (std::filesystem::temp_directory_path() / "atrium-shapes-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        throw Error(ExitCode::environment, "no temporary folder", name, "", "free some space");
    }
    folder_ = name;
    path_ = folder_ / "shapes.atrium";
    write_bake(path_, data);
    bake_ = std::make_unique<BakeFile>(path_);
}

TempBake::~TempBake()
{
    bake_.reset();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

} // namespace atrium::truth
