// check_scene: one broken thing at a time.

#include "tests/scene/bake_refusal.hpp"
#include "tests/scene/bake_rig.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace atrium {
namespace {

using namespace bake_rig;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

void check(const BakeData& d)
{
    check_scene(d.scene, d.vertices.size() * sizeof(Vertex), d.indices.size() * 4, d.texels.size(), "test");
}

struct Case {
    const char* element; ///< named in the message
    std::function<void(Scene&)> damage;
};

void expect_all_refused(const std::vector<Case>& cases)
{
    const BakeData whole = rich_bake();
    ASSERT_NO_THROW(check(whole));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        SCOPED_TRACE(i);
        BakeData data = whole;
        cases[i].damage(data.scene);
        const std::string text = refusal([&] { check(data); });
        EXPECT_TRUE(has(text, cases[i].element)) << text;
    }
}

TEST(bake_check, materials)
{
    expect_all_refused({
        {"material 3", [](Scene& s) { s.materials[3].base_color_texture = 8; }},
        {"material 3", [](Scene& s) { s.materials[3].normal_texture = -2; }},
        {"material 3", [](Scene& s) { s.materials[3].surface_texture = 0x7fffffff; }},
        {"material 3", [](Scene& s) { s.materials[3].emission_texture = -0x7fffffff - 1; }},
        {"material 0", [](Scene& s) { s.materials[0].base_color.y = nan; }},
        {"material 0", [](Scene& s) { s.materials[0].emission.z = inf; }},
        {"material 0", [](Scene& s) { s.materials[0].opacity = -inf; }},
        {"material 0", [](Scene& s) { s.materials[0].alpha_cutoff = nan; }},
        {"material 0", [](Scene& s) { s.materials[0].roughness = nan; }},
        {"material 0", [](Scene& s) { s.materials[0].metallic = nan; }},
        {"material 0", [](Scene& s) { s.materials[0].specular = nan; }},
        {"class", [](Scene& s) { s.materials[4].cls = static_cast<MaterialClass>(4); }},
        {"material 4", [](Scene& s) { s.materials[4].name.assign(65536, 'x'); }},
        {"mesh", [](Scene& s) { s.materials.resize(2); }},
    });
}

TEST(bake_check, textures)
{
    expect_all_refused({
        {"texture 1", [](Scene& s) { s.textures[1].width = 0; }},
        {"texture 1", [](Scene& s) { s.textures[1].height = 16385; }},
        {"texture 1", [](Scene& s) { s.textures[1].width = 0xffffffffu; }},
        {"more than its size allows", [](Scene& s) { s.textures[0].mips = 0; }},
        {"more than its size allows", [](Scene& s) { s.textures[0].mips = 6; }}, // 16 x 12 has five
        {"more than its size allows", [](Scene& s) { s.textures[0].mips = 0xffffffffu; }},
        {"format is unknown", [](Scene& s) { s.textures[0].format = static_cast<TextureFormat>(8); }},
        {"texture 0", [](Scene& s) { s.textures[0].mips = 3; }}, // smaller than its size says
        {"texture 2", [](Scene& s) { s.textures[2].size += 16; }},
        {"texture 2", [](Scene& s) { s.textures[2].offset += 8; }},
        {"texture 2", [](Scene& s) { s.textures[2].offset = ~std::uint64_t{15}; }},
        {"texture 7", [](Scene& s) { s.textures[7].offset += 16; }},
        {"overlaps", [](Scene& s) { s.textures[2].offset -= 16; }},
        {"overlaps", [](Scene& s) { s.textures.push_back(s.textures[0]); }},
        {"texels",
         [](Scene& s) {
             for (Material& m : s.materials) m.base_color_texture = m.normal_texture = m.surface_texture = -1;
             for (Material& m : s.materials) m.emission_texture = -1;
             s.textures.clear();
         }},
        {"texture 5", [](Scene& s) { s.textures[5].file.assign(65536, 'x'); }},
    });
}

TEST(bake_check, meshes_and_clusters)
{
    // Index and cluster order of the rig: meshes 2 (clusters 0 to 3), 0 (4 to 10), 1 (11).
    expect_all_refused({
        {"mesh 1", [](Scene& s) { s.meshes[1].material = 5; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].index_count += 1; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].index_count += 3; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].index_count = 0; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].first_index = 0xffffffffu; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].index_count = 0xffffffffu; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].first_vertex = 0xffffffffu; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].vertex_count = 0xffffffffu; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].vertex_count += 1; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].vertex_count = 0; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].cluster_count = 0; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].cluster_count = 2; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].cluster_count = 0xffffffffu; }},
        {"mesh 1", [](Scene& s) { s.meshes[1].first_cluster = 12; }},
        {"mesh", [](Scene& s) { s.meshes[1].first_cluster = 10; }},
        {"mesh", [](Scene& s) { s.meshes[0].first_index += 3; }},
        {"mesh 0", [](Scene& s) { s.meshes[0].bounds.min.x = nan; }},
        {"mesh 0", [](Scene& s) { s.meshes[0].bounds.max.y = inf; }},
        {"mesh 0", [](Scene& s) { s.meshes[0].bounds = {}; }},
        {"mesh 0", [](Scene& s) { s.meshes[0].name.assign(65536, 'x'); }},
        {"mesh", [](Scene& s) { s.meshes.push_back(s.meshes[0]); }},
        {"mesh", [](Scene& s) { s.meshes.erase(s.meshes.begin()); }},
        {"indices belong",
         [](Scene& s) {
             s.meshes.erase(s.meshes.begin() + 1);
             s.clusters.pop_back();
         }},
        {"there is no mesh", [](Scene& s) { s.meshes.clear(); }},
        {"belong to no mesh", [](Scene& s) { s.clusters.push_back(s.clusters[0]); }},
        {"cluster 5", [](Scene& s) { s.clusters[5].centre.x = nan; }},
        {"cluster 5", [](Scene& s) { s.clusters[5].radius = nan; }},
        {"cluster 5", [](Scene& s) { s.clusters[5].radius = -1; }},
        {"cluster 5", [](Scene& s) { s.clusters[5].cone_axis.z = inf; }},
        {"cluster 5", [](Scene& s) { s.clusters[5].cone_cutoff = nan; }},
        {"cluster 5", [](Scene& s) { s.clusters[5].first_index -= 3; }},
        {"cluster 5", [](Scene& s) { s.clusters[5].index_count = 0; }},
        {"cluster 5", [](Scene& s) { s.clusters[5].index_count += 1; }},
        {"cluster 6", [](Scene& s) { s.clusters[5].index_count += 3; }},
        {"mesh 0", [](Scene& s) { s.clusters[10].index_count += 3; }},
        {"mesh 0", [](Scene& s) { s.clusters[10].index_count = 0xffffffffu; }},
    });
}

TEST(bake_check, the_whole)
{
    expect_all_refused({
        {"bounds", [](Scene& s) { s.bounds = {}; }},
        {"bounds", [](Scene& s) { s.bounds.max.x = inf; }},
        {"section vertices", [](Scene& s) { s.vertex_count += 1; }},
        {"section vertices", [](Scene& s) { s.vertex_count -= 1; }},
        {"vertices", [](Scene& s) { s.vertex_count = ~std::uint64_t{0} / 28 + 1 + s.vertex_count; }},
        {"section indices", [](Scene& s) { s.index_count += 3; }},
        {"indices", [](Scene& s) { s.index_count += std::uint64_t{1} << 62; }},
        {"source", [](Scene& s) { s.source.assign(65536, 'x'); }},
        {"warning 1", [](Scene& s) { s.warnings[1].kind.assign(65536, 'x'); }},
        {"4097 kinds of warnings", [](Scene& s) { s.warnings.resize(4097); }},
    });
}

TEST(bake_check, limits)
{
    // One more than allowed of everything but clusters: those would take 800 MB.
    expect_all_refused({
        {"65537 materials", [](Scene& s) { s.materials.resize(65537); }},
        {"65537 textures", [](Scene& s) { s.textures.resize(65537); }},
        {"1048577 meshes", [](Scene& s) { s.meshes.resize(1048577); }},
    });
    BakeData data = tiny_bake();
    data.scene.vertex_count = (std::uint64_t{1} << 31) + 1;
    const std::string vertices =
        refusal([&] { check_scene(data.scene, data.scene.vertex_count * 28, 24, 32, "test"); });
    EXPECT_TRUE(has(vertices, "2147483649 vertices")) << vertices;
    data = tiny_bake();
    data.scene.index_count = std::uint64_t{1} << 32;
    const std::string indices =
        refusal([&] { check_scene(data.scene, 4 * 28, data.scene.index_count * 4, 32, "test"); });
    EXPECT_TRUE(has(indices, "4294967296 indices")) << indices;
}

TEST(bake_check, texels_that_belong_to_nothing)
{
    BakeData data = tiny_bake();
    data.texels.resize(data.texels.size() + 4095);
    EXPECT_NO_THROW(check(data));
    data.scene.textures[0].offset = 4096; // behind a gap as long as an alignment could never leave
    data.texels.resize(4096 + data.scene.textures[0].size);
    EXPECT_TRUE(has(refusal([&] { check(data); }), "unused texels"));
    data.scene.textures[0].offset = 0;
    EXPECT_TRUE(has(refusal([&] { check(data); }), "section texels"));
}

TEST(bake_check, the_longest_names_are_allowed)
{
    BakeData data = tiny_bake();
    data.scene.meshes[0].name.assign(65535, 'x');
    EXPECT_NO_THROW(check(data));
}

TEST(bake_check, what_could_not_be_read_is_not_written)
{
    const TempFolder folder;
    BakeData data = tiny_bake();
    data.scene.meshes[0].material = 1;
    refusal([&] { write_bake(folder / "bad.atrium", data); });
    EXPECT_FALSE(std::filesystem::exists(folder / "bad.atrium"));
}

} // namespace
} // namespace atrium
