// Every index, range and number of a scene against its counts and the sizes of the bulk sections.

#include "renderer/scene/bake_file.hpp"
#include "renderer/scene/bake_internal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace atrium {
namespace {

bool finite(const vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool sound(const Bounds& b)
{
    return finite(b.min) && finite(b.max) && !b.empty();
}

/// [first, first + count) lies within [0, size). All of 64 bit: nothing wraps.
bool within(std::uint64_t first, std::uint64_t count, std::uint64_t size)
{
    return first <= size && count <= size - first;
}

class Check {
public:
    Check(const Scene& scene, const std::string& where) : scene_(scene), where_(where) {}

    void counts() const;
    void sizes(std::uint64_t vertices_size, std::uint64_t indices_size) const;
    void materials() const;
    void textures(std::uint64_t texels_size) const;
    void meshes() const;
    void clusters(std::size_t mesh) const;
    void shares() const;

private:
    /// Texts are made on failure only: there are millions of clusters.
    void need(bool ok, const char* kind, std::size_t index, const char* why) const
    {
        if (!ok) bake::refuse(fmt::format("{}, {} {}", where_, kind, index), "section archive", why);
    }
    void need(bool ok, const char* why) const
    {
        if (!ok) bake::refuse(where_, "section archive", why);
    }
    void need_at_most(std::uint64_t count, std::uint64_t limit, const char* what) const
    {
        if (count > limit) {
            bake::refuse(where_, "section archive", fmt::format("{} {}, at most {} are allowed", count, what, limit));
        }
    }
    void need_size(std::uint64_t size, std::uint64_t count, std::uint64_t each, const char* section) const
    {
        if (size != count * each) {
            bake::refuse(where_, std::string("section ") + section,
                         fmt::format("it has {} bytes, {} x {} are expected", size, count, each));
        }
    }
    /// The numbers 0 to count - 1 in the order of `key`.
    template <class Key>
    static std::vector<std::uint32_t> ordered(std::size_t count, Key key)
    {
        std::vector<std::uint32_t> order(count);
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        return order;
    }

    const Scene& scene_;
    const std::string& where_;
};

void Check::counts() const
{
    need_at_most(scene_.materials.size(), bake::max_materials, "materials");
    need_at_most(scene_.textures.size(), bake::max_textures, "textures");
    need_at_most(scene_.meshes.size(), bake::max_meshes, "meshes");
    need_at_most(scene_.clusters.size(), bake::max_clusters, "clusters");
    need_at_most(scene_.warnings.size(), bake::max_warnings, "kinds of warnings");
    need_at_most(scene_.vertex_count, bake::max_vertices, "vertices");
    need_at_most(scene_.index_count, bake::max_indices, "indices");
    need_at_most(scene_.source.size(), bake::max_text, "bytes in the source's name");
    need(!scene_.meshes.empty(), "there is no mesh: nothing to draw");
    need(sound(scene_.bounds), "the scene's bounds are empty or not finite");
    for (std::size_t i = 0; i < scene_.warnings.size(); ++i) {
        const BakeWarning& w = scene_.warnings[i];
        need(w.kind.size() <= bake::max_text && w.first.size() <= bake::max_text, "warning", i, "its text is too long");
    }
}

void Check::sizes(std::uint64_t vertices_size, std::uint64_t indices_size) const
{
    need_size(vertices_size, scene_.vertex_count, sizeof(Vertex), "vertices");
    need_size(indices_size, scene_.index_count, sizeof(std::uint32_t), "indices");
}

void Check::materials() const
{
    const auto texture_count = static_cast<std::int64_t>(scene_.textures.size());
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
        const Material& m = scene_.materials[i];
        need(m.name.size() <= bake::max_text, "material", i, "its name is too long");
        need(static_cast<int>(m.cls) < material_class_count, "material", i, "its class is unknown");
        bool numbers = finite(m.base_color) && finite(m.emission);
        for (const float f : {m.opacity, m.alpha_cutoff, m.roughness, m.metallic, m.specular}) {
            numbers = numbers && std::isfinite(f);
        }
        need(numbers, "material", i, "a number is not finite");
        for (const std::int32_t t : {m.base_color_texture, m.normal_texture, m.surface_texture, m.emission_texture}) {
            need(t >= no_texture && t < texture_count, "material", i, "it names a texture that is not there");
        }
    }
}

void Check::textures(std::uint64_t texels_size) const
{
    const std::vector<Texture>& all = scene_.textures;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Texture& t = all[i];
        need(t.file.size() <= bake::max_text, "texture", i, "its name is too long");
        need(t.format <= TextureFormat::bc5_unorm, "texture", i, "its format is unknown");
        const auto size_ok = [](std::uint32_t n) { return n >= 1 && n <= bake::max_texture_size; };
        need(size_ok(t.width) && size_ok(t.height), "texture", i, "its width or height is not within 1 to 16384");
        const auto chain = static_cast<std::uint32_t>(std::bit_width(std::max(t.width, t.height)));
        need(t.mips >= 1 && t.mips <= chain, "texture", i, "it has no mips or more than its size allows");
        need(t.offset % texel_alignment == 0, "texture", i, "its offset is not aligned");
        need(within(t.offset, t.size, texels_size), "texture", i, "it reaches beyond the texels section");
        need(t.size == mip_offsets(t.format, t.width, t.height, t.mips).back(), "texture", i,
             "its size is not that of its mips");
    }
    // Texels may not be shared: many large textures out of a few bytes would fill the device's memory.
    std::uint64_t end = 0;
    for (const std::uint32_t i : ordered(all.size(), [&](std::uint32_t t) { return all[t].offset; })) {
        need(all[i].offset >= end, "texture", i, "it overlaps another one");
        need(all[i].offset - end < bake::section_alignment, "texture", i, "unused texels stand before it");
        end = all[i].offset + all[i].size;
    }
    if (texels_size - end >= bake::section_alignment) {
        bake::refuse(where_, "section texels",
                     fmt::format("it has {} bytes, the textures end at {}", texels_size, end));
    }
}

void Check::meshes() const
{
    for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
        const Mesh& m = scene_.meshes[i];
        need(m.name.size() <= bake::max_text, "mesh", i, "its name is too long");
        need(m.material < scene_.materials.size(), "mesh", i, "it names a material that is not there");
        need(sound(m.bounds), "mesh", i, "its bounds are empty or not finite");
        need(m.index_count > 0 && m.index_count % 3 == 0, "mesh", i, "its indices are not whole triangles");
        need(within(m.first_index, m.index_count, scene_.index_count), "mesh", i, "its indices are not there");
        need(m.vertex_count > 0, "mesh", i, "it has no vertices");
        need(within(m.first_vertex, m.vertex_count, scene_.vertex_count), "mesh", i, "its vertices are not there");
        need(m.cluster_count > 0, "mesh", i, "it has no clusters");
        need(within(m.first_cluster, m.cluster_count, scene_.clusters.size()), "mesh", i, "its clusters are not there");
    }
    shares(); // before the clusters are walked: then all meshes together walk each once
    for (std::size_t i = 0; i < scene_.meshes.size(); ++i) clusters(i);
}

/// No cluster and no index belongs to two meshes or to none: otherwise a small file could ask for endless drawing.
void Check::shares() const
{
    const std::vector<Mesh>& all = scene_.meshes;
    std::uint64_t end = 0;
    for (const std::uint32_t i : ordered(all.size(), [&](std::uint32_t m) { return all[m].first_cluster; })) {
        need(all[i].first_cluster == end, "mesh", i, "its clusters do not follow on another mesh's");
        end += all[i].cluster_count;
    }
    need(end == scene_.clusters.size(), "clusters belong to no mesh");
    end = 0;
    for (const std::uint32_t i : ordered(all.size(), [&](std::uint32_t m) { return all[m].first_index; })) {
        need(all[i].first_index == end, "mesh", i, "its indices do not follow on another mesh's");
        end += all[i].index_count;
    }
    need(end == scene_.index_count, "indices belong to no mesh");
}

/// The clusters of a mesh, one after the other, are its indices.
void Check::clusters(std::size_t mesh) const
{
    const Mesh& m = scene_.meshes[mesh];
    std::uint64_t next = m.first_index;
    for (std::size_t i = m.first_cluster; i < std::size_t{m.first_cluster} + m.cluster_count; ++i) {
        const Cluster& c = scene_.clusters[i];
        need(finite(c.centre) && finite(c.cone_axis) && std::isfinite(c.cone_cutoff), "cluster", i,
             "a number is not finite");
        need(std::isfinite(c.radius) && c.radius >= 0, "cluster", i, "its radius is no radius");
        need(c.index_count > 0 && c.index_count % 3 == 0, "cluster", i, "its indices are not whole triangles");
        need(c.first_index == next, "cluster", i, "its indices do not follow on those before it");
        next += c.index_count;
    }
    need(next == std::uint64_t{m.first_index} + m.index_count, "mesh", mesh, "its clusters are not all of its indices");
}

} // namespace

void check_scene(const Scene& scene, std::uint64_t vertices_size, std::uint64_t indices_size, std::uint64_t texels_size,
                 const std::string& where)
{
    const Check check(scene, where);
    check.counts();
    check.sizes(vertices_size, indices_size);
    check.materials();
    check.textures(texels_size);
    check.meshes();
}

} // namespace atrium
