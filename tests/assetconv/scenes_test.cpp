// Real scenes, where the environment's ATRIUM_SCENES names a folder of them.

#include "bake_rig.hpp"

#include "assetconv/mask_mips.hpp"
#include "renderer/core/error.hpp"

#include <map>
#include <set>

namespace atrium {
namespace {

std::filesystem::path scene(const char* file)
{
    const char* folder = std::getenv("ATRIUM_SCENES");
    if (folder == nullptr) return {};
    return std::filesystem::path(folder) / file;
}

TEST(scenes, sponza_comes_through_right)
{
    BakeOptions options;
    options.input = scene("sponza/sponza_nobanner.obj");
    if (options.input.empty()) GTEST_SKIP() << "ATRIUM_SCENES names no folder of scenes";
    options.scale = 0.01f;
    const BakeData bake = bake_scene(options);
    const Scene& s = bake.scene;

    const std::uint64_t dropped =
        test::warnings_of(bake, "face-degenerate") + test::warnings_of(bake, "face-duplicate");
    EXPECT_EQ(s.index_count / 3 + dropped, 262267u);
    EXPECT_LT(dropped, 10u);
    EXPECT_EQ(test::warnings_of(bake, "texture-missing"), 0u);
    const vec3 size = s.bounds.extent();
    EXPECT_NEAR(size.x, 37.2f, 0.05f);
    EXPECT_NEAR(size.y, 15.6f, 0.05f);
    EXPECT_NEAR(size.z, 22.9f, 0.05f);

    std::set<std::uint32_t> used;
    std::set<std::string> masked, bumpy;
    for (const Mesh& m : s.meshes) used.insert(m.material);
    EXPECT_EQ(s.materials.size(), 26u);
    EXPECT_EQ(used.size(), 25u);
    for (const Material& m : s.materials) {
        if (m.cls == MaterialClass::masked) masked.insert(m.name);
        EXPECT_LE(m.cls, MaterialClass::masked) << m.name;
        if (m.normal_texture != no_texture) bumpy.insert(m.name);
        EXPECT_EQ(m.metallic, 0) << m.name;
        EXPECT_EQ(m.opacity, 1) << m.name;
        EXPECT_FLOAT_EQ(m.specular, 0.04f) << m.name;
        if (m.surface_texture != no_texture) continue;
        EXPECT_NEAR(m.roughness, 0.6389f, 1e-4f) << m.name;
    }
    EXPECT_EQ(masked, (std::set<std::string>{"leaf", "Material__57", "chain"}));
    EXPECT_EQ(bumpy, (std::set<std::string>{"leaf", "vase_round", "Material__298", "bricks", "column_a", "column_b",
                                            "column_c", "chain", "Material__25"}));
    for (const Mesh& m : s.meshes)
        EXPECT_EQ(m.two_sided, s.materials[m.material].cls == MaterialClass::masked) << m.name;
}

TEST(scenes, sponza_normal_maps_are_all_turned_green_up)
{
    BakeOptions options;
    options.input = scene("sponza/sponza_nobanner.obj");
    if (options.input.empty()) GTEST_SKIP() << "ATRIUM_SCENES names no folder of scenes";
    options.max_texture_size = 64;
    const BakeData found = bake_scene(options);
    options.normal_y = NormalY::down;
    EXPECT_EQ(found.texels, bake_scene(options).texels); // every one of them was found to be green down
}

TEST(scenes, masks_keep_their_area_in_every_mip)
{
    if (scene("").empty()) GTEST_SKIP() << "ATRIUM_SCENES names no folder of scenes";
    int masks = 0;
    for (const char* file :
         {"sponza/sponza_nobanner.obj", "foliage/bush/bush.obj", "foliage/christmas_tree/christmas_tree.obj"}) {
        BakeOptions options;
        options.input = scene(file);
        const BakeData bake = bake_scene(options);
        for (const Material& m : bake.scene.materials) {
            if (m.cls != MaterialClass::masked) continue;
            const Texture& t = bake.scene.textures[static_cast<std::size_t>(m.base_color_texture)];
            const auto offsets = mip_offsets(t.format, t.width, t.height, t.mips);
            double wanted = 0;
            for (std::uint32_t mip = 0; mip < t.mips; ++mip) {
                const std::uint32_t width = std::max(1u, t.width >> mip), height = std::max(1u, t.height >> mip);
                MaskLevel<std::uint8_t> level{static_cast<int>(width), static_cast<int>(height), {}};
                for (std::size_t i = 0; i < std::size_t{width} * height; ++i)
                    level.alpha.push_back(static_cast<std::uint8_t>(bake.texels[t.offset + offsets[mip] + i * 4 + 3]));
                const double area = covered_area(level, {m.alpha_cutoff / m.opacity, t.clamp});
                if (mip == 0) wanted = area;
                EXPECT_NEAR(area, wanted, 0.03 * std::min(wanted, 1 - wanted)) << t.file << " " << mip;
            }
            EXPECT_LE(std::max(t.width, t.height) >> (t.mips - 1), 8u) << t.file; // leaves last until they are specks
            ++masks;
        }
    }
    EXPECT_EQ(masks, 5);
}

TEST(scenes, all_others_bake_or_say_why_not)
{
    const std::filesystem::path folder = scene("");
    if (folder.empty()) GTEST_SKIP() << "ATRIUM_SCENES names no folder of scenes";
    int baked = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".obj" || entry.path().stem() == "sponza_nobanner") continue;
        BakeOptions options;
        options.input = entry.path();
        options.max_texture_size = 64;
        try {
            const BakeData bake = bake_scene(options);
            check_scene(bake.scene, bake.vertices.size() * sizeof(Vertex), bake.indices.size() * 4, bake.texels.size(),
                        "");
            ++baked;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ExitCode::input) << entry.path();
        }
    }
    EXPECT_GT(baked, 50);
}

TEST(scenes, triangle_counts_of_known_models)
{
    if (scene("").empty()) GTEST_SKIP() << "ATRIUM_SCENES names no folder of scenes";
    const std::map<std::string, std::uint64_t> known{
        {"classics/teapot.obj", 6320},
        {"classics/stanford-bunny.obj", 69451},
        {"classics/cornell_box.obj", 32},
        {"spider/spider.obj", 1368},
        {"foliage/bush/bush.obj", 40292},
        {"foliage/christmas_tree/christmas_tree.obj", 15552}, // sum of corners - 2
        {"medieval_building/Medieval_building.obj", 16715},
        {"pool_table/poolTable.obj", 57184}};
    for (const auto& [file, triangles] : known) {
        BakeOptions options;
        options.input = scene(file.c_str());
        options.max_texture_size = 64;
        const BakeData bake = bake_scene(options);
        const std::uint64_t dropped =
            test::warnings_of(bake, "face-degenerate") + test::warnings_of(bake, "face-duplicate");
        EXPECT_EQ(bake.scene.index_count / 3 + dropped, triangles) << file;
    }
}

} // namespace
} // namespace atrium
