// Primary visibility of scenes whose pictures are known.

#include "tests/truth/compare.hpp"
#include "tests/truth/primary.hpp"
#include "tests/truth/scene_builder.hpp"

#include "renderer/core/jobs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace atrium::truth {
namespace {

dvec3 triple(const ImageF& image, int x, int y)
{
    return {image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2]};
}

TEST(primary, a_tilted_plane_has_its_analytic_depth_position_and_normal)
{
    // The plane through the origin with normal (0.36, 0.48, 0.8), seen from (0, 0, 3) along -z with 60 degrees.
    const dvec3 n(0.36, 0.48, 0.8);
    const vec3 u(0.8f, -0.6f, 0), v = glm::cross(vec3(n), u);
    SceneBuilder builder;
    builder.add_mesh("plane", builder.add_material("plane"),
                     quad(-50.0f * u - 50.0f * v, 100.0f * u, 100.0f * v, {7, 5}));
    const TempBake bake(builder.finish());
    const TruthScene scene(bake.file());
    const ivec2 size(64, 36);
    const PrimaryBuffers seen = cast_primary(scene, {{0, 0, 3}, {0, 0, 0}, 60}, size);
    const double t = std::tan(3.14159265358979323846 / 6);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const dvec3 d((2 * (x + 0.5) / size.x - 1) * t * size.x / size.y, (1 - 2 * (y + 0.5) / size.y) * t, -1);
            const double depth = -glm::dot(n, dvec3(0, 0, 3)) / glm::dot(n, d);
            ASSERT_NEAR(*seen.depth.at(x, y), depth, 2e-6 * depth) << x << ' ' << y;
            ASSERT_LT(glm::length(triple(seen.position, x, y) - (dvec3(0, 0, 3) + depth * d)), 1e-5) << x << ' ' << y;
            ASSERT_LT(glm::length(triple(seen.geometric_normal, x, y) - n), 1e-6) << x << ' ' << y;
            ASSERT_LT(glm::length(triple(seen.shading_normal, x, y) - n), 1e-4) << x << ' ' << y; // 16-bit octahedral
        }
    }
    EXPECT_EQ(seen.surface.share(), 1);
    EXPECT_EQ(seen.alpha.share(), 0);
}

TEST(primary, the_first_row_looks_up_and_the_first_column_left)
{
    const TempBake bake(wall_and_floor(2)); // the wall stands in x = 0, facing +x
    const TruthScene scene(bake.file());
    const PrimaryBuffers seen = cast_primary(scene, {{2, 1, 0}, {2, 1, -1}, 100}, {41, 41});
    EXPECT_FALSE(seen.surface.at(40, 0));
    EXPECT_EQ(*seen.mesh.at(40, 40), 0);
    EXPECT_EQ(*seen.mesh.at(0, 20), 1);
    EXPECT_TRUE(std::isinf(*seen.depth.at(40, 0)));
    EXPECT_EQ(*seen.material.at(40, 0), -1);
    EXPECT_EQ(seen.primitive[40], no_primitive);
    EXPECT_LT(seen.primitive[seen.surface.index(0, 20)], 2u);
}

TEST(primary, a_camera_that_looks_straight_down_has_z_as_its_up)
{
    const TempBake bake(wall_and_floor(2));
    const TruthScene scene(bake.file());
    const Camera camera{{3, 5, 1}, {3, 0, 1}, 40};
    const PrimaryBuffers seen = cast_primary(scene, camera, {9, 9});
    EXPECT_GT(triple(seen.position, 4, 0).z, 1.5);
    EXPECT_LT(triple(seen.position, 4, 8).z, 0.5);
    // The renderer's matrix puts what a pixel saw back into that pixel.
    const mat4 clip_from_world = clip_from_view(camera.fov, 1, 0.1f) * view_from_world(camera);
    const vec4 clip = clip_from_world * vec4(vec3(triple(seen.position, 7, 2)), 1);
    EXPECT_NEAR((0.5f + 0.5f * clip.x / clip.w) * 9, 7.5f, 1e-3f);
    EXPECT_NEAR((0.5f - 0.5f * clip.y / clip.w) * 9, 2.5f, 1e-3f);
}

TEST(primary, agrees_with_the_renderers_camera_off_axis)
{
    const TempBake bake(box_on_floor());
    const TruthScene scene(bake.file());
    const Camera camera{{2.5f, 1.3f, -1.7f}, {0.1f, 0.4f, 0.3f}, 53};
    const ivec2 size(97, 51);
    const PrimaryBuffers seen = cast_primary(scene, camera, size);
    const mat4 clip_from_world =
        clip_from_view(camera.fov, static_cast<float>(size.x) / static_cast<float>(size.y), 0.1f) *
        view_from_world(camera);
    for (const ivec2 p : {ivec2(3, 48), ivec2(48, 25), ivec2(90, 40), ivec2(50, 45)}) {
        ASSERT_TRUE(seen.surface.at(p.x, p.y));
        const vec4 clip = clip_from_world * vec4(vec3(triple(seen.position, p.x, p.y)), 1);
        EXPECT_NEAR((0.5f + 0.5f * clip.x / clip.w) * 97, static_cast<float>(p.x) + 0.5f, 1e-3f);
        EXPECT_NEAR((0.5f - 0.5f * clip.y / clip.w) * 51, static_cast<float>(p.y) + 0.5f, 1e-3f);
        EXPECT_NEAR(clip.w, *seen.depth.at(p.x, p.y), 1e-5f * clip.w);
    }
}

TEST(primary, backs_of_one_sided_meshes_are_passed_through)
{
    BakeData data = box_on_floor();
    const Camera from_below{{0, -3, 0.1f}, {0, 0.5f, 0}, 30};
    {
        const TempBake bake(data);
        const TruthScene scene(bake.file());
        const PrimaryBuffers seen = cast_primary(scene, from_below, {15, 15});
        EXPECT_EQ(*seen.mesh.at(7, 7), 1); // the box's bottom faces down; the floor above it does not
        EXPECT_NEAR(seen.geometric_normal.at(7, 7)[1], -1, 1e-6);
        const PrimaryBuffers inside = cast_primary(scene, {{0, 0.5f, 0}, {1, 0.5f, 0}, 30}, {15, 15});
        EXPECT_FALSE(inside.surface.at(7, 3)); // out through the side's back
    }
    data.scene.meshes[1].two_sided = true;
    const TempBake bake(data);
    const TruthScene scene(bake.file());
    const PrimaryBuffers inside = cast_primary(scene, {{0, 0.5f, 0}, {1, 0.5f, 0}, 30}, {15, 15});
    EXPECT_EQ(*inside.mesh.at(7, 3), 1);
    EXPECT_NEAR(inside.geometric_normal.at(7, 3)[0], -1, 1e-6); // towards the camera
    EXPECT_NEAR(inside.shading_normal.at(7, 3)[0], -1, 1e-4);
}

TEST(primary, secondary_rays_are_stopped_by_backs)
{
    const std::array<std::uint8_t, 1> solid{255};
    BakeData data = masked_scene(1, 1, solid);
    data.scene.meshes[1].two_sided = data.scene.materials[1].two_sided = false;
    const TempBake bake(data);
    const TruthScene scene(bake.file());
    // From behind both: first the back of the opaque wall in z = -1, then that of the masked square in z = 0.
    const Ray ray{{0.1, 0.2, -3}, {0, 0, 1}};
    EXPECT_FALSE(scene.first_hit(ray, Facing::cull));
    const auto hit = scene.first_hit(ray, Facing::any);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->mesh, 0u);
    EXPECT_FALSE(hit->front);
    EXPECT_NEAR(hit->distance, 2, 1e-6);
    EXPECT_TRUE(scene.occluded({ray.origin, ray.direction, 0, 2.5}));
    EXPECT_TRUE(scene.occluded({ray.origin, ray.direction, 2.5, 3.5}));
    EXPECT_FALSE(scene.occluded({ray.origin, ray.direction, 2.1, 2.9}));
}

TEST(primary, nothing_nearer_than_the_near_plane_is_seen)
{
    const TempBake bake(box_on_floor());
    const TruthScene scene(bake.file());
    const Camera camera{{0, 0.5f, 1.5f}, {0, 0.5f, 0}, 90}; // the box's face is 1 m away everywhere
    EXPECT_EQ(*cast_primary(scene, camera, {9, 9}, 0.99).mesh.at(3, 4), 1);
    EXPECT_EQ(cast_primary(scene, camera, {9, 9}, 1.01).surface.at(3, 3), false);
}

TEST(primary, threads_do_not_change_the_picture)
{
    const TempBake bake(sphere_on_floor(1));
    const TruthScene scene(bake.file());
    const Camera camera{{2, 2, 3}, {0, 1, 0}, 60};
    const PrimaryBuffers many = cast_primary(scene, camera, {80, 45});
    set_job_threads(1);
    const PrimaryBuffers one = cast_primary(scene, camera, {80, 45});
    set_job_threads(0);
    EXPECT_EQ(many.depth.values, one.depth.values);
    EXPECT_EQ(many.geometric_normal.values, one.geometric_normal.values);
    EXPECT_EQ(many.primitive, one.primitive);
}

TEST(silhouettes, of_a_box_are_its_outline_two_pixels_wide_on_either_side)
{
    // A box of 1 m in mid-air, face on from 2 m before its front: 90 degrees over 80 pixels, so 20 pixels a metre
    // there.
    SceneBuilder builder;
    builder.add_mesh("box", builder.add_material("box"), box({-0.5f, -0.5f, -1}, {0.5f, 0.5f, 0}));
    const TempBake bake(builder.finish());
    const TruthScene scene(bake.file());
    const PrimaryBuffers seen = cast_primary(scene, {{0, 0, 2}, {0, 0, 0}, 90}, {80, 80});
    const Mask edges = silhouettes(seen);
    // The face covers pixels 30 to 49. An edge pixel has the other mesh within one pixel (29, 30); one more each side.
    for (int x = 0; x < 80; ++x) {
        const bool expected = (x >= 28 && x <= 31) || (x >= 48 && x <= 51);
        EXPECT_EQ(edges.at(x, 40), expected) << x;
    }
    EXPECT_NEAR(edges.share(), (24.0 * 24 - 16 * 16) / 6400, 1e-9);
}

TEST(silhouettes, find_creases_and_steps_within_one_mesh)
{
    // One mesh: two floors, the right one `step` lower, 4 m below the eye; seen straight from above.
    const auto excluded = [](float step, float tilt) {
        Shape shape = quad({-5, 0, 5}, {5, 0, 0}, {0, 0, -10});
        shape.add(quad({0, -step, 5}, {5, tilt, 0}, {0, 0, -10}));
        SceneBuilder builder;
        builder.add_mesh("floors", builder.add_material("floor"), shape);
        const TempBake bake(builder.finish());
        const TruthScene scene(bake.file());
        return silhouettes(cast_primary(scene, {{0, 4, 0}, {0, 0, 0}, 60}, {64, 64})).share();
    };
    EXPECT_EQ(excluded(0, 0), 0);
    EXPECT_EQ(excluded(0.03f, 0), 0); // 0.75 % of the depth
    EXPECT_NEAR(excluded(0.05f, 0), 4.0 / 64, 1e-9);
    EXPECT_EQ(excluded(0, 0.3f), 0);                // 3 degrees
    EXPECT_NEAR(excluded(0, 2.6f), 4.0 / 64, 0.02); // 27 degrees
}

} // namespace
} // namespace atrium::truth
