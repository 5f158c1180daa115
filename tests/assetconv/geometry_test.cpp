// Triangles, generated normals, sides, axes.

#include "bake_rig.hpp"

#include "assetconv/normals.hpp"
#include "renderer/core/error.hpp"
#include "renderer/scene/vertex_packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

using test::bake_text;
using test::Folder;
using test::warnings_of;

/// A cube with outward winding, with or without normals.
std::string cube(bool normals, bool inwards = false)
{
    std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                       "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 0 1 0\nvn -1 0 0\nvn 1 0 0\n";
    const std::array<std::array<int, 4>, 6> sides{
        {{4, 3, 2, 1}, {5, 6, 7, 8}, {1, 2, 6, 5}, {3, 4, 8, 7}, {1, 5, 8, 4}, {2, 3, 7, 6}}};
    for (std::size_t s = 0; s < 6; ++s) {
        text += "f";
        for (std::size_t i = 0; i < 4; ++i) {
            text += fmt::format(" {}", sides[s][inwards ? 3 - i : i]);
            if (normals) text += fmt::format("//{}", s + 1);
        }
        text += "\n";
    }
    return text;
}

TEST(geometry, a_cube_is_counted_right)
{
    const Folder folder;
    const BakeData bake = bake_text(folder, cube(true));
    EXPECT_EQ(bake.scene.index_count, 36u);
    EXPECT_EQ(bake.scene.vertex_count, 24u); // four per side: no normal is shared
    EXPECT_EQ(bake.scene.bounds.min, vec3(0));
    EXPECT_EQ(bake.scene.bounds.max, vec3(1));
    EXPECT_EQ(bake.scene.materials.at(0).name, "default");
}

TEST(geometry, scale_and_up_axis)
{
    const Folder folder;
    BakeOptions options;
    options.scale = 0.01f;
    options.up = UpAxis::z;
    const BakeData bake =
        bake_text(folder, "v 100 200 300\nv 200 200 300\nv 100 300 300\nvn 0 0 1\nf 1//1 2//1 3//1\n", options);
    EXPECT_LT(glm::distance(bake.scene.bounds.min, vec3(1, 3, -3)), 1e-5f); // (x, y, z) to (x, z, -y)
    EXPECT_LT(glm::distance(bake.scene.bounds.max, vec3(2, 3, -2)), 1e-5f);
    EXPECT_LT(glm::distance(unpack_normal(bake.vertices.at(0).normal), vec3(0, 1, 0)), 1e-4f);
    EXPECT_FALSE(bake.scene.meshes.at(0).two_sided); // the turn is no mirror: winding still agrees
}

TEST(geometry, degenerate_and_duplicate_faces_are_dropped_and_counted)
{
    const Folder folder;
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 0 0 0\nvn 0 0 1\n";
    const BakeData bake =
        bake_text(folder, points + "f 1//1 2//1 3//1\n"   // the one that stays
                                   "f 2//1 3//1 5//1\n"   // the same: point 5 is point 1
                                   "f 1//1 2//1 4//1\n"   // on a line
                                   "f 1//1 5//1 2//1\n"   // two equal corners
                                   "f 3//1 2//1 1//1\n"); // reversed: in a one-sided mesh it would stay
    EXPECT_EQ(warnings_of(bake, "face-degenerate"), 2u);
    EXPECT_TRUE(bake.scene.meshes.at(0).two_sided); // one of two winds against its normals
    EXPECT_EQ(warnings_of(bake, "face-duplicate"), 2u);
    EXPECT_EQ(bake.scene.index_count, 3u);
}

TEST(geometry, a_mesh_is_one_sided_only_where_winding_and_normals_agree)
{
    const Folder folder;
    EXPECT_FALSE(bake_text(folder, cube(true)).scene.meshes.at(0).two_sided);
    EXPECT_TRUE(bake_text(folder, cube(true, true)).scene.meshes.at(0).two_sided);
    EXPECT_TRUE(bake_text(folder, cube(false)).scene.meshes.at(0).two_sided);
    BakeOptions off, on;
    off.two_sided = TwoSided::off;
    on.two_sided = TwoSided::on;
    EXPECT_FALSE(bake_text(folder, cube(false), off).scene.meshes.at(0).two_sided);
    EXPECT_TRUE(bake_text(folder, cube(true), on).scene.meshes.at(0).two_sided);
}

/// An open ball with uvs and one normal a vertex; `turned(face)` says which faces wind against them.
template <class Turned>
std::string ball(Turned&& turned)
{
    constexpr int rings = 8, slices = 12;
    std::string text;
    for (int j = 0; j <= rings; ++j) {
        for (int i = 0; i <= slices; ++i) {
            const float a = 0.2f + 2.7f * static_cast<float>(j) / rings,
                        b = 6.2831853f * static_cast<float>(i % slices) / slices;
            const vec3 p(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
            text += fmt::format("v {0} {1} {2}\nvn {0} {1} {2}\nvt {3} {4}\n", p.x, p.y, p.z, i, j);
        }
    }
    const auto corner = [](int j, int i) { return j * (slices + 1) + i + 1; };
    for (int j = 0, face = 0; j < rings; ++j) {
        for (int i = 0; i < slices; ++i) {
            std::array<int, 4> c{corner(j, i), corner(j, i + 1), corner(j + 1, i + 1), corner(j + 1, i)};
            if (turned(face++)) std::swap(c[1], c[3]);
            text += fmt::format("f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2} {3}/{3}/{3}\n", c[0], c[1], c[2], c[3]);
        }
    }
    return text;
}

/// How many triangles wind against their vertex normals.
int wound_against_normals(const BakeData& bake)
{
    int count = 0;
    for (std::size_t i = 0; i < bake.indices.size(); i += 3) {
        const auto v = [&](std::size_t k) { return bake.vertices[bake.indices[i + k]]; };
        const vec3 across = glm::cross(v(1).position - v(0).position, v(2).position - v(0).position);
        count += glm::dot(across, unpack_normal(v(0).normal) + unpack_normal(v(1).normal)) < 0 ? 1 : 0;
    }
    return count;
}

TEST(geometry, mixed_winding_is_turned_to_the_normals)
{
    const Folder folder;
    const BakeData right = bake_text(folder, ball([](int) { return false; }));
    EXPECT_EQ(wound_against_normals(right), 0);
    EXPECT_EQ(warnings_of(right, "winding-turned"), 0u);
    for (const auto& turned :
         {+[](int face) { return face % 2 == 0; }, +[](int face) { return face > 10; }, +[](int) { return true; }}) {
        const BakeData mixed = bake_text(folder, ball(turned));
        EXPECT_EQ(wound_against_normals(mixed), 0);
        EXPECT_EQ(mixed.indices.size(), right.indices.size());
        EXPECT_TRUE(mixed.scene.meshes.at(0).two_sided);
        int faces = 0;
        for (int i = 0; i < 96; ++i) faces += turned(i) ? 1 : 0;
        EXPECT_EQ(warnings_of(mixed, "winding-turned"), 2u * static_cast<unsigned>(faces));
        // Tangents and their handedness are those of the right ball too.
        const auto corners = [](const BakeData& bake) {
            std::vector<std::array<float, 6>> all;
            for (const Vertex& v : bake.vertices) {
                all.push_back(
                    {v.position.x, v.position.y, v.position.z, v.uv.x, v.uv.y, static_cast<float>(v.tangent >> 31)});
            }
            std::sort(all.begin(), all.end());
            return all;
        };
        EXPECT_EQ(corners(mixed), corners(right));
    }
}

TEST(geometry, winding_is_left_alone_where_it_is_said_to_be_right_or_nothing_tells)
{
    const Folder folder;
    BakeOptions off;
    off.two_sided = TwoSided::off;
    EXPECT_EQ(wound_against_normals(bake_text(folder, ball([](int face) { return face < 48; }), off)), 96);
    EXPECT_EQ(warnings_of(bake_text(folder, cube(false, true)), "winding-turned"), 0u); // no normals to follow
}

TEST(geometry, ninety_nine_percent_agreement_is_enough)
{
    const auto strip = [](int reversed) {
        std::string text = "vn 0 0 1\n";
        for (int i = 0; i < 100; ++i) {
            text += fmt::format("v {0} 0 0\nv {1} 0 0\nv {0} 1 0\n", 2 * i, 2 * i + 1);
            text += i < reversed ? "f -1//1 -2//1 -3//1\n" : "f -3//1 -2//1 -1//1\n";
        }
        return text;
    };
    const Folder folder;
    const BakeData reliable = bake_text(folder, strip(1)), mixed = bake_text(folder, strip(2));
    EXPECT_FALSE(reliable.scene.meshes.at(0).two_sided);
    EXPECT_EQ(wound_against_normals(reliable), 1); // as the file has it
    EXPECT_TRUE(mixed.scene.meshes.at(0).two_sided);
    EXPECT_EQ(wound_against_normals(mixed), 0);
}

/// Normals of the vertices at a point.
std::vector<vec3> normals_at(const BakeData& bake, const vec3& p)
{
    std::vector<vec3> normals;
    for (const Vertex& v : bake.vertices) {
        if (v.position == p) normals.push_back(unpack_normal(v.normal));
    }
    return normals;
}

TEST(geometry, missing_normals_follow_the_smoothing_angle)
{
    const Folder folder;
    EXPECT_EQ(normals_at(bake_text(folder, cube(false)), vec3(1)).size(), 3u); // 90 degrees is an edge
    BakeOptions smooth;
    smooth.smooth_angle = 91.0f;
    const auto corner = normals_at(bake_text(folder, cube(false), smooth), vec3(1));
    ASSERT_EQ(corner.size(), 1u);
    // Weighted by angle, not by triangle: each side has 90 degrees here, cut into two triangles or not.
    EXPECT_LT(glm::distance(corner[0], vec3(0.57735f)), 1e-4f);
}

TEST(geometry, missing_normals_follow_smoothing_groups)
{
    const Folder folder;
    EXPECT_EQ(normals_at(bake_text(folder, "s 1\n" + cube(false)), vec3(1)).size(), 1u);
    const std::string roof = "v 0 0 0\nv 1 0 0\nv 1 0.1 1\nv 0 0.1 1\nv 1 0 2\nv 0 0 2\n";
    EXPECT_EQ(normals_at(bake_text(folder, roof + "s off\nf 1 4 3 2\nf 4 6 5 3\n"), vec3(1, 0.1f, 1)).size(), 2u);
    EXPECT_EQ(normals_at(bake_text(folder, roof + "s 1\nf 1 4 3 2\ns 2\nf 4 6 5 3\n"), vec3(1, 0.1f, 1)).size(), 2u);
    EXPECT_EQ(normals_at(bake_text(folder, roof + "f 1 4 3 2\nf 4 6 5 3\n"), vec3(1, 0.1f, 1)).size(), 1u);
}

TEST(geometry, meshes_are_groups_times_materials_in_file_order)
{
    const Folder folder;
    folder.write("m.mtl", "newmtl a\nnewmtl unused\nnewmtl b\n");
    const std::string points = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    const BakeData bake =
        bake_text(folder, points + "g x\nusemtl b\nf 1 2 3\nusemtl a\nf 2 4 3\ng y\nf 1 2 4\ng x\nusemtl b\nf 1 4 3\n"
                                   "usemtl nowhere\nf 1 2 3\n");
    std::vector<std::pair<std::string, std::uint32_t>> meshes;
    for (const Mesh& m : bake.scene.meshes) meshes.emplace_back(m.name, m.material);
    EXPECT_EQ(meshes, (std::vector<std::pair<std::string, std::uint32_t>>{{"x", 2}, {"x", 0}, {"y", 0}, {"x", 3}}));
    EXPECT_EQ(bake.scene.meshes[0].index_count, 6u);
    ASSERT_EQ(bake.scene.materials.size(), 4u);
    EXPECT_EQ(bake.scene.materials[1].name, "unused");
    EXPECT_EQ(bake.scene.materials[3].name, "default");
    EXPECT_EQ(warnings_of(bake, "material-undefined"), 1u);
}

TEST(geometry, nothing_to_draw_is_an_input_error)
{
    const Folder folder;
    try {
        (void)bake_text(folder, "v 0 0 0\nv 1 0 0\nl 1 2\n");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::input);
    }
}

} // namespace
} // namespace atrium
