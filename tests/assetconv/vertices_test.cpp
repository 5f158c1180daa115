#include "bake_rig.hpp"

#include "assetconv/vertices.hpp"
#include "renderer/scene/vertex_packing.hpp"

#include <random>
#include <set>

namespace atrium {
namespace {

using test::bake_text;
using test::Folder;

TEST(vertices, a_grid_welds_to_its_points)
{
    const Folder folder;
    std::string text = "vn 0 0 1\n";
    for (int y = 0; y <= 10; ++y) {
        for (int x = 0; x <= 10; ++x) {
            text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
            text += "vt " + std::to_string(x * 0.1) + " " + std::to_string(y * 0.1) + "\n";
        }
    }
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x) {
            text += "f";
            for (const int i : {0, 1, 12, 11}) {
                const std::string at = std::to_string(y * 11 + x + i + 1);
                text += " " + at + "/" + at + "/1";
            }
            text += "\n";
        }
    }
    const BakeData bake = bake_text(folder, text);
    EXPECT_EQ(bake.scene.vertex_count, 121u);
    EXPECT_EQ(bake.scene.index_count, 600u);
    for (const Vertex& v : bake.vertices) {
        const vec4 t = unpack_tangent(v.tangent);
        EXPECT_LT(glm::distance(vec3(t), vec3(1, 0, 0)), 1e-3f);
        EXPECT_EQ(t.w, 1.0f);
        EXPECT_NEAR(v.uv.y, 1 - v.position.y * 0.1f, 1e-5f); // v is flipped once
    }
}

TEST(vertices, tangent_and_bitangent_follow_the_image)
{
    // u along +y, v along +x: mirrored. The image's right is +y, its up +x.
    const Folder folder;
    const BakeData bake =
        bake_text(folder, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0 1\nvt 1 1\nvt 1 0\nvn 0 0 1\n"
                          "f 1/1/1 2/2/1 3/3/1 4/4/1\n");
    ASSERT_EQ(bake.vertices.size(), 4u);
    for (const Vertex& v : bake.vertices) {
        const vec4 t = unpack_tangent(v.tangent);
        const vec3 n = unpack_normal(v.normal);
        EXPECT_LT(glm::distance(vec3(t), vec3(0, 1, 0)), 1e-3f);
        EXPECT_EQ(t.w, -1.0f);
        EXPECT_LT(glm::distance(t.w * glm::cross(n, vec3(t)), vec3(1, 0, 0)), 1e-3f);
    }
}

TEST(vertices, a_mirrored_seam_splits_and_only_there)
{
    // Two squares side by side that share an edge; the right one's u runs back.
    const Folder folder;
    const std::string points = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nvn 0 0 1\n";
    const BakeData mirrored = bake_text(folder, points + "vt 0 0\nvt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\nvt 0 1\n"
                                                         "f 1/1/1 2/2/1 5/5/1 4/4/1\nf 2/2/1 3/3/1 6/6/1 5/5/1\n");
    EXPECT_EQ(mirrored.scene.vertex_count, 8u);
    for (const Vertex& v : mirrored.vertices) {
        const vec4 t = unpack_tangent(v.tangent);
        const vec3 b = t.w * glm::cross(unpack_normal(v.normal), vec3(t));
        EXPECT_LT(glm::distance(b, vec3(0, 1, 0)), 1e-3f); // v runs up on both sides: lit alike
        EXPECT_NEAR(t.x, t.w, 1e-3f);
    }
    const BakeData plain = bake_text(folder, points + "vt 0 0\nvt 1 0\nvt 2 0\nvt 0 1\nvt 1 1\nvt 2 1\n"
                                                      "f 1/1/1 2/2/1 5/5/1 4/4/1\nf 2/2/1 3/3/1 6/6/1 5/5/1\n");
    EXPECT_EQ(plain.scene.vertex_count, 6u);
}

TEST(vertices, triangles_without_uv_area_get_a_frame_and_split_nothing)
{
    const Folder folder;
    const BakeData none = bake_text(folder, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    EXPECT_EQ(none.scene.vertex_count, 4u);
    const BakeData beside = bake_text(folder, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nvt 0 0\nvt 0 1\nvt 1 1\nvn 0 0 1\n"
                                              "f 2/2/1 4/2/1 3/3/1\nf 1/1/1 2/2/1 3/3/1\n"); // the second is mirrored
    EXPECT_EQ(beside.scene.vertex_count, 4u);
    for (const BakeData* bake : {&none, &beside}) {
        for (const Vertex& v : bake->vertices) {
            const vec4 t = unpack_tangent(v.tangent);
            EXPECT_NEAR(glm::dot(vec3(t), unpack_normal(v.normal)), 0, 1e-3f);
            EXPECT_NEAR(glm::length(vec3(t)), 1, 1e-3f);
        }
    }
}

TEST(vertices, map_options_move_the_uvs)
{
    const Folder folder;
    folder.write_image("c.png", 2, 2, 3, [](int x, int y) { return test::Rgb{x * 255, y * 255, 0}; });
    const BakeData bake = test::bake_material(folder, "map_Kd -s 2 4 -o 0.25 0.5 c.png\n");
    Bounds uv;
    for (const Vertex& v : bake.vertices) uv.add(vec3(v.uv, 0));
    EXPECT_EQ(vec2(uv.min), vec2(0.25f, 1 - 4.5f));
    EXPECT_EQ(vec2(uv.max), vec2(2.25f, 1 - 0.5f));
}

} // namespace
} // namespace atrium
