// The scene kit makes bakes that hold what they say.

#include "renderer/scene/vertex_packing.hpp"
#include "tests/truth/scene_builder.hpp"

#include <gtest/gtest.h>

#include <array>

namespace atrium::truth {
namespace {

/// Signed volume of a closed mesh: positive when its triangles face outwards.
double volume(const Shape& s)
{
    double sum = 0;
    for (std::size_t i = 0; i < s.triangles.size(); i += 3) {
        const glm::dvec3 a(s.vertices[s.triangles[i]].position), b(s.vertices[s.triangles[i + 1]].position),
            c(s.vertices[s.triangles[i + 2]].position);
        sum += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return sum;
}

TEST(shapes, closed_ones_face_outwards)
{
    EXPECT_NEAR(volume(box({-1, 0, 2}, {1, 3, 4})), 12, 1e-9);
    EXPECT_NEAR(volume(sphere({5, 1, 2}, 2, 128)), 4.0 / 3 * 3.14159265 * 8, 0.08);
}

TEST(shapes, vertex_normals_agree_with_the_winding_and_tangents_with_uv)
{
    for (const Shape& s : {box({-1, 0, 2}, {1, 3, 4}), sphere({0, 0, 0}, 1, 32), ground(3, 1, {2, 3}),
                           quad({0, 0, 0}, {0, 2, 0}, {0, 0, 1})}) {
        for (std::size_t i = 0; i < s.triangles.size(); i += 3) {
            const ShapeVertex &a = s.vertices[s.triangles[i]], &b = s.vertices[s.triangles[i + 1]],
                              &c = s.vertices[s.triangles[i + 2]];
            const vec3 ab = b.position - a.position, ac = c.position - a.position;
            const vec3 n = glm::normalize(glm::cross(ab, ac));
            ASSERT_GT(glm::dot(n, a.normal), 0.9f);
            // dP/du and -dP/dv (up the image) from this triangle, against tangent and bitangent.
            const vec2 duv1 = b.uv - a.uv, duv2 = c.uv - a.uv;
            const float det = duv1.x * duv2.y - duv1.y * duv2.x;
            ASSERT_NE(det, 0);
            const vec3 du = (ab * duv2.y - ac * duv1.y) / det, up = (ab * duv2.x - ac * duv1.x) / det;
            ASSERT_GT(glm::dot(glm::normalize(du), a.tangent), 0.85f);
            ASSERT_GT(glm::dot(glm::normalize(up), glm::cross(a.normal, a.tangent)), 0.85f);
        }
    }
}

TEST(shapes, every_scene_is_written_opened_and_verified)
{
    const std::array<std::uint8_t, 15> alpha{};
    for (const BakeData& data :
         {floor_scene(), wall_and_floor(), corner_scene(), ceiling_scene(2), sphere_on_floor(1, 40), box_on_floor(),
          plate_over_floor(1), masked_scene(5, 3, alpha)}) {
        const TempBake bake(data);
        EXPECT_NO_THROW((void)verify_bake(bake.path()));
        EXPECT_EQ(bake.file().scene().meshes.size(), data.scene.meshes.size());
        EXPECT_EQ(bake.file().vertices().size(), data.vertices.size() * sizeof(Vertex));
    }
}

TEST(shapes, clusters_hold_their_triangles_and_cones_never_hide_a_front)
{
    const BakeData data = sphere_on_floor(1, 32);
    const Mesh& mesh = data.scene.meshes[1];
    EXPECT_GT(mesh.cluster_count, 4u);
    int culled = 0;
    for (std::uint32_t k = 0; k < mesh.cluster_count; ++k) {
        const Cluster& c = data.scene.clusters[mesh.first_cluster + k];
        for (const vec3 eye : {vec3(3, 1, 0), vec3(0, 8, 0), vec3(-2, -5, 1), vec3(0, 1, 0), vec3(30, 2, 40)}) {
            const vec3 d = c.centre - eye;
            const bool hidden =
                c.cone_cutoff < 1 && glm::dot(d, c.cone_axis) >= c.cone_cutoff * glm::length(d) + c.radius;
            culled += hidden ? 1 : 0;
            for (std::uint32_t i = c.first_index; i < c.first_index + c.index_count; i += 3) {
                const vec3 p = data.vertices[data.indices[i]].position;
                EXPECT_LE(glm::length(p - c.centre), c.radius);
                const vec3 n = glm::cross(data.vertices[data.indices[i + 1]].position - p,
                                          data.vertices[data.indices[i + 2]].position - p);
                if (hidden) {
                    EXPECT_GE(glm::dot(n, p - eye), -1e-7f);
                }
            }
        }
    }
    EXPECT_GT(culled, 0);
}

TEST(shapes, textures_have_whole_mip_chains)
{
    SceneBuilder builder;
    const std::array<std::uint8_t, 8> alpha{0, 255, 255, 255, 0, 255, 255, 255};
    builder.add_alpha_texture(4, 2, alpha);
    const BakeData data = builder.finish();
    const Texture& t = data.scene.textures[0];
    ASSERT_EQ(t.mips, 3u);
    const auto offsets = mip_offsets(t.format, 4, 2, 3);
    EXPECT_EQ(data.texels[offsets[1] + 3], std::byte{128}); // 2x1: (0 + 255 + 0 + 255) / 4
    EXPECT_EQ(data.texels[offsets[1] + 7], std::byte{255});
    EXPECT_EQ(data.texels[offsets[2] + 3], std::byte{192}); // 1x1
}

} // namespace
} // namespace atrium::truth
