// What is written is what is read.

#include "tests/scene/bake_rig.hpp"

#include <gtest/gtest.h>

namespace atrium {
namespace {

using namespace bake_rig;

void expect_equal(const Material& a, const Material& b)
{
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.cls, b.cls);
    EXPECT_EQ(a.two_sided, b.two_sided);
    EXPECT_EQ(a.base_color, b.base_color);
    EXPECT_EQ(a.opacity, b.opacity);
    EXPECT_EQ(a.alpha_cutoff, b.alpha_cutoff);
    EXPECT_EQ(a.roughness, b.roughness);
    EXPECT_EQ(a.metallic, b.metallic);
    EXPECT_EQ(a.specular, b.specular);
    EXPECT_EQ(a.emission, b.emission);
    EXPECT_EQ(a.base_color_texture, b.base_color_texture);
    EXPECT_EQ(a.normal_texture, b.normal_texture);
    EXPECT_EQ(a.surface_texture, b.surface_texture);
    EXPECT_EQ(a.emission_texture, b.emission_texture);
}

void expect_equal(const Texture& a, const Texture& b)
{
    EXPECT_EQ(a.file, b.file);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.mips, b.mips);
    EXPECT_EQ(a.format, b.format);
    EXPECT_EQ(a.clamp, b.clamp);
    EXPECT_EQ(a.offset, b.offset);
    EXPECT_EQ(a.size, b.size);
}

void expect_equal(const Bounds& a, const Bounds& b)
{
    EXPECT_EQ(a.min, b.min);
    EXPECT_EQ(a.max, b.max);
}

void expect_equal(const Mesh& a, const Mesh& b)
{
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.material, b.material);
    EXPECT_EQ(a.first_index, b.first_index);
    EXPECT_EQ(a.index_count, b.index_count);
    EXPECT_EQ(a.first_vertex, b.first_vertex);
    EXPECT_EQ(a.vertex_count, b.vertex_count);
    EXPECT_EQ(a.first_cluster, b.first_cluster);
    EXPECT_EQ(a.cluster_count, b.cluster_count);
    EXPECT_EQ(a.two_sided, b.two_sided);
    expect_equal(a.bounds, b.bounds);
}

void expect_equal(const Cluster& a, const Cluster& b)
{
    EXPECT_EQ(a.centre, b.centre);
    EXPECT_EQ(a.radius, b.radius);
    EXPECT_EQ(a.cone_axis, b.cone_axis);
    EXPECT_EQ(a.cone_cutoff, b.cone_cutoff);
    EXPECT_EQ(a.first_index, b.first_index);
    EXPECT_EQ(a.index_count, b.index_count);
}

void expect_equal(const BakeWarning& a, const BakeWarning& b)
{
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.count, b.count);
    EXPECT_EQ(a.first, b.first);
}

template <class T>
void expect_equal(const std::vector<T>& a, const std::vector<T>& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        SCOPED_TRACE(i);
        expect_equal(a[i], b[i]);
    }
}

void expect_equal(const Scene& a, const Scene& b)
{
    expect_equal(a.materials, b.materials);
    expect_equal(a.textures, b.textures);
    expect_equal(a.meshes, b.meshes);
    expect_equal(a.clusters, b.clusters);
    expect_equal(a.warnings, b.warnings);
    expect_equal(a.bounds, b.bounds);
    EXPECT_EQ(a.vertex_count, b.vertex_count);
    EXPECT_EQ(a.index_count, b.index_count);
    EXPECT_EQ(a.source, b.source);
}

bool same_bytes(std::span<const std::byte> a, std::span<const std::byte> b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

TEST(bake, everything_that_is_written_is_read_again)
{
    const TempFolder folder;
    const BakeData data = rich_bake();
    write_bake(folder / "rich.atrium", data);
    const BakeFile bake(folder / "rich.atrium");
    expect_equal(data.scene, bake.scene());
    EXPECT_TRUE(same_bytes(std::as_bytes(std::span(data.vertices)), bake.vertices()));
    EXPECT_TRUE(same_bytes(std::as_bytes(std::span(data.indices)), bake.indices()));
    EXPECT_TRUE(same_bytes(data.texels, bake.texels()));
    EXPECT_EQ(bake.path(), folder / "rich.atrium");
}

TEST(bake, the_same_data_give_the_same_bytes)
{
    const TempFolder folder;
    write_bake(folder / "a.atrium", rich_bake());
    write_bake(folder / "b.atrium", rich_bake());
    EXPECT_EQ(read_bytes(folder / "a.atrium"), read_bytes(folder / "b.atrium"));
}

TEST(bake, the_layout_is_the_one_of_the_documentation)
{
    const TempFolder folder;
    write_bake(folder / "rich.atrium", rich_bake());
    const Bytes file = read_bytes(folder / "rich.atrium");
    EXPECT_EQ(std::memcmp(file.data(), "ATRIUM\r\n", 8), 0);
    EXPECT_EQ(get<std::uint32_t>(file, 8), 1u);
    EXPECT_EQ(get<std::uint32_t>(file, 12), 0x01020304u);
    EXPECT_EQ(get<std::uint32_t>(file, 16), 8u);
    EXPECT_EQ(get<std::uint32_t>(file, 20), 4u);
    EXPECT_EQ(get<std::uint64_t>(file, 24), file.size());
    std::uint64_t end = 200;
    const char* names[] = {"archive", "vertices", "indices", "texels"};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t entry = 40 + 40 * i;
        EXPECT_STREQ(reinterpret_cast<const char*>(file.data() + entry), names[i]);
        const auto offset = get<std::uint64_t>(file, entry + 16), size = get<std::uint64_t>(file, entry + 24);
        EXPECT_EQ(offset % 4096, 0u);
        EXPECT_LT(offset - end, 4096u);
        for (std::uint64_t k = end; k < offset; ++k) ASSERT_EQ(file[k], std::byte{0}) << k;
        EXPECT_EQ(get<std::uint64_t>(file, entry + 32), hash64(std::span(file).subspan(offset, size)));
        end = offset + size;
    }
    EXPECT_EQ(end, file.size());
}

TEST(bake, a_scene_without_textures_is_valid)
{
    const TempFolder folder;
    BakeData data = tiny_bake();
    data.scene.textures.clear();
    data.scene.materials[0].base_color_texture = no_texture;
    data.texels.clear();
    write_bake(folder / "tiny.atrium", data);
    EXPECT_TRUE(BakeFile(folder / "tiny.atrium").texels().empty());
    EXPECT_EQ(verify_bake(folder / "tiny.atrium").size(), 4u);
}

TEST(bake, a_moved_bake_keeps_its_sections)
{
    const TempFolder folder;
    const BakeData data = tiny_bake();
    write_bake(folder / "tiny.atrium", data);
    BakeFile first(folder / "tiny.atrium");
    const BakeFile bake = std::move(first);
    EXPECT_TRUE(same_bytes(std::as_bytes(std::span(data.indices)), bake.indices()));
}

TEST(bake, verify_tells_of_every_section)
{
    const TempFolder folder;
    write_bake(folder / "rich.atrium", rich_bake());
    const std::vector<std::string> lines = verify_bake(folder / "rich.atrium");
    ASSERT_EQ(lines.size(), bake::section_names.size());
    for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_TRUE(lines[i].starts_with(bake::section_names[i]));
}

} // namespace
} // namespace atrium
