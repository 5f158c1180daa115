#pragma once
// Bakes for tests: small valid ones, and the means to tamper with a file and set its hashes right again.

#include "renderer/core/hash.hpp"
#include "renderer/scene/bake_file.hpp"
#include "renderer/scene/bake_format.hpp"
#include "renderer/scene/vertex_packing.hpp"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace atrium::bake_rig {

using Bytes = std::vector<std::byte>;

/// A folder of its own, gone with the test.
class TempFolder {
public:
    TempFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "atrium-bake-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~TempFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;
    [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

inline Bytes read_bytes(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

inline void write_bytes(const std::filesystem::path& file, std::span<const std::byte> bytes)
{
    std::filesystem::remove(file); // a file that is cut and written again is flushed to the disk by some file systems
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!out) throw std::runtime_error("cannot write " + file.string());
}

template <class T>
T get(const Bytes& bytes, std::size_t offset)
{
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

template <class T>
void put(Bytes& bytes, std::size_t offset, const T& value)
{
    std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

inline constexpr std::size_t table_offset = sizeof(bake::Header);
inline constexpr std::size_t table_end = table_offset + sizeof(bake::Table);

inline bake::Header header(const Bytes& file)
{
    return get<bake::Header>(file, 0);
}
inline bake::Table table(const Bytes& file)
{
    return get<bake::Table>(file, table_offset);
}

/// Makes every hash of a tampered file right again: of the sections where the table still says where they are, then
/// of header and table.
inline void rehash(Bytes& file)
{
    bake::Table entries = table(file);
    for (bake::SectionEntry& e : entries) {
        if (e.offset > file.size() || e.size > file.size() - e.offset) continue;
        e.hash = hash64(std::span(file).subspan(e.offset, e.size));
    }
    put(file, table_offset, entries);
    put(file, offsetof(bake::Header, hash), std::uint64_t{0});
    put(file, offsetof(bake::Header, hash), hash64(std::span(file).first(table_end)));
}

inline Bytes section(const Bytes& file, bake::Section s)
{
    const bake::SectionEntry e = table(file)[s];
    const auto bytes = std::span(file).subspan(e.offset, e.size);
    return {bytes.begin(), bytes.end()};
}

/// The file with another section in place of one, laid out anew, all hashes right.
inline Bytes with_section(const Bytes& file, bake::Section replaced, const Bytes& bytes)
{
    Bytes out(file.begin(), file.begin() + table_end);
    bake::Table entries = table(file);
    for (std::uint32_t s = 0; s < bake::section_count; ++s) {
        const Bytes content = s == replaced ? bytes : section(file, static_cast<bake::Section>(s));
        out.resize(bake::align_section(out.size()));
        entries[s].offset = out.size();
        entries[s].size = content.size();
        out.insert(out.end(), content.begin(), content.end());
    }
    put(out, table_offset, entries);
    put(out, offsetof(bake::Header, file_size), std::uint64_t{out.size()});
    rehash(out);
    return out;
}

/// A square of two metres around the origin in the plane z = 0, facing +Z: one mesh of one cluster, one material with
/// a 2x2 texture.
inline BakeData tiny_bake()
{
    BakeData d;
    const std::uint32_t normal = pack_normal({0, 0, 1}), tangent = pack_tangent({1, 0, 0}, 1.0f);
    d.vertices = {{{-1, -1, 0}, normal, tangent, {0, 1}},
                  {{1, -1, 0}, normal, tangent, {1, 1}},
                  {{1, 1, 0}, normal, tangent, {1, 0}},
                  {{-1, 1, 0}, normal, tangent, {0, 0}}};
    d.indices = {0, 1, 2, 0, 2, 3};

    const auto offsets = mip_offsets(TextureFormat::rgba8_srgb, 2, 2, 2);
    d.scene.textures = {{"white.png", 2, 2, 2, TextureFormat::rgba8_srgb, false, 0, offsets.back()}};
    d.texels.assign(offsets.back(), std::byte{255});
    Material material;
    material.name = "white";
    material.base_color_texture = 0;
    d.scene.materials = {material};

    Cluster cluster;
    cluster.radius = 1.5f;
    cluster.index_count = 6;
    d.scene.clusters = {cluster};
    Mesh mesh;
    mesh.name = "square";
    mesh.index_count = 6;
    mesh.vertex_count = 4;
    mesh.cluster_count = 1;
    mesh.bounds = {{-1, -1, 0}, {1, 1, 0}};
    d.scene.meshes = {mesh};
    d.scene.bounds = mesh.bounds;
    d.scene.vertex_count = 4;
    d.scene.index_count = 6;
    d.scene.source = "square.obj";
    return d;
}

/// Every kind of thing that a bake can hold, and no two numbers alike, so that exchanged fields are seen: three meshes
/// in another order than their indices and clusters, every texture format, every material class, warnings.
inline BakeData rich_bake()
{
    BakeData d;
    Scene& s = d.scene;
    float next = 1.0f;
    const auto number = [&] { return next += 0.125f; };
    const auto vector = [&] { return vec3(number(), -number(), number()); };
    s.source = "rich scene.obj";
    s.bounds = {{-100, -200, -300}, {400, 500, 600}};

    for (int f = 0; f <= static_cast<int>(TextureFormat::bc5_unorm); ++f) {
        Texture t;
        t.file = "folder/texture " + std::to_string(f) + ".png+other.tga";
        t.width = 16u << (f % 3);
        t.height = 12;
        t.mips = f % 2 == 0 ? 4u : 1u;
        t.format = static_cast<TextureFormat>(f);
        t.clamp = f % 2 == 1;
        t.offset = (d.texels.size() + texel_alignment - 1) / texel_alignment * texel_alignment;
        t.size = mip_offsets(t.format, t.width, t.height, t.mips).back();
        d.texels.resize(t.offset + t.size);
        s.textures.push_back(t);
    }
    for (std::size_t i = 0; i < d.texels.size(); ++i) d.texels[i] = static_cast<std::byte>(i * 37 + i / 256);

    for (int i = 0; i < 5; ++i) {
        Material m;
        m.name = std::string(static_cast<std::size_t>(i) * 9, 'm') + std::to_string(i);
        m.cls = static_cast<MaterialClass>(i % material_class_count);
        m.two_sided = i % 2 == 1;
        m.base_color = vector();
        m.opacity = number();
        m.alpha_cutoff = number();
        m.roughness = number();
        m.metallic = number();
        m.specular = number();
        m.emission = vector();
        m.base_color_texture = i;
        m.normal_texture = i + 1;
        m.surface_texture = i + 2;
        m.emission_texture = i == 4 ? no_texture : i + 3;
        s.materials.push_back(m);
    }

    // Index and cluster order: meshes 2, 0, 1.
    const std::uint32_t vertex_counts[] = {300, 20, 150}, cluster_counts[] = {7, 1, 4};
    s.meshes.resize(3);
    std::uint32_t first_vertex = 0;
    for (const std::uint32_t i : {2u, 0u, 1u}) {
        Mesh& m = s.meshes[i];
        m.name = "mesh " + std::to_string(i);
        m.material = i + 1;
        m.first_index = static_cast<std::uint32_t>(d.indices.size());
        m.first_vertex = first_vertex;
        m.vertex_count = vertex_counts[i];
        m.first_cluster = static_cast<std::uint32_t>(s.clusters.size());
        m.cluster_count = cluster_counts[i];
        m.two_sided = i == 1;
        m.bounds.min = vec3(-number(), -number(), -number());
        m.bounds.max = vec3(number(), number(), number());
        for (std::uint32_t c = 0; c < m.cluster_count; ++c) {
            Cluster cluster;
            cluster.centre = vector();
            cluster.radius = number();
            cluster.cone_axis = vector();
            cluster.cone_cutoff = number();
            cluster.first_index = static_cast<std::uint32_t>(d.indices.size());
            cluster.index_count = 3 * (20 + c);
            for (std::uint32_t k = 0; k < cluster.index_count; ++k) {
                d.indices.push_back(first_vertex + (c * 31 + k * 7) % m.vertex_count);
            }
            s.clusters.push_back(cluster);
        }
        m.index_count = static_cast<std::uint32_t>(d.indices.size()) - m.first_index;
        first_vertex += m.vertex_count;
    }
    for (std::uint32_t i = 0; i < first_vertex; ++i) {
        d.vertices.push_back({vector(), i * 2654435761u, i * 40503u, vec2(number(), number())});
    }
    s.vertex_count = d.vertices.size();
    s.index_count = d.indices.size();
    s.warnings = {{"texture not found", 3, "rich.mtl:12"}, {"degenerate triangle", 1234567890123u, ""}};
    return d;
}

} // namespace atrium::bake_rig
