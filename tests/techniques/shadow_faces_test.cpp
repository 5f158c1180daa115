// The geometry of shadow maps, without a device.

#include "renderer/techniques/shadow/light_points.hpp"
#include "renderer/techniques/shadow/shadow_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace atrium {
namespace {

const Bounds room = [] {
    Bounds b;
    b.add(vec3(-12, 0, -6));
    b.add(vec3(12, 10, 6));
    return b;
}();

Camera looking(const vec3& eye, const vec3& target)
{
    return {eye, target, 60};
}

float along(const vec4& row, const vec3& p)
{
    return glm::dot(row, vec4(p, 1));
}

TEST(shadow_faces, cascades_split_where_the_paper_says)
{
    const std::vector<float> ends = cascade_splits(0.1f, 100, 4, 0.75f);
    const std::vector<float> known{6.6905f, 14.8842f, 32.0933f, 100};
    for (std::size_t i = 0; i < known.size(); ++i) EXPECT_NEAR(ends[i], known[i], 1e-3f);
}

TEST(shadow_faces, a_slice_s_corners_lie_in_its_sphere_and_two_of_them_on_it)
{
    const double tan_y = std::tan(0.5), tan_x = 16.0 / 9 * tan_y, k2 = tan_x * tan_x + tan_y * tan_y;
    for (const auto& [from, to] : {std::pair{0.1, 3.0}, {3.0, 9.0}, {9.0, 100.0}}) {
        const SliceSphere s = slice_sphere(from, to, k2);
        const auto distance = [&](double z) { return std::sqrt(k2 * z * z + (z - s.centre) * (z - s.centre)); };
        EXPECT_LE(distance(from), s.radius * (1 + 1e-9));
        EXPECT_NEAR(distance(to), s.radius, 1e-9 * s.radius);
    }
}

TEST(shadow_faces, cascades_move_by_whole_texels_and_the_last_stays)
{
    Light sun = default_light(LightType::sun);
    constexpr std::uint32_t side = 1024;
    const LightFaces first = light_faces(sun, room, {looking({-5, 2, 0}, {5, 2, 0.4f}), 16.0f / 9, 4, side}, 0);
    ASSERT_EQ(first.faces.size(), 4u);
    for (int step = 1; step < 40; ++step) {
        const float d = 0.0037f * static_cast<float>(step);
        const Camera moved = looking({-5 + d, 2 + 0.5f * d, 0.3f * d}, {5, 2 - d, 0.4f});
        const LightFaces now = light_faces(sun, room, {moved, 16.0f / 9, 4, side}, 0);
        for (std::size_t f = 0; f < 4; ++f) {
            EXPECT_EQ(now.faces[f].scale, first.faces[f].scale);
            const vec2 shift = vec2(now.faces[f].x.w - first.faces[f].x.w, now.faces[f].y.w - first.faces[f].y.w);
            const vec2 texels = shift * (0.5f * side);
            EXPECT_NEAR(texels.x, std::round(texels.x), 2e-3f) << f;
            EXPECT_NEAR(texels.y, std::round(texels.y), 2e-3f) << f;
        }
        EXPECT_EQ(now.faces[3].x, first.faces[3].x);
    }
}

TEST(shadow_faces, the_last_cascade_holds_the_whole_scene_and_depths_lie_between_0_and_1)
{
    Light sun = default_light(LightType::sun);
    sun.direction = {0.4f, -1, 0.2f};
    const LightFaces faces = light_faces(sun, room, {looking({0, 2, 0}, {1, 2, 0}), 16.0f / 9, 4, 1024}, 0);
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 p(corner & 1 ? room.max.x : room.min.x, corner & 2 ? room.max.y : room.min.y,
                     corner & 4 ? room.max.z : room.min.z);
        EXPECT_LT(std::abs(along(faces.faces[3].x, p)), 1);
        EXPECT_LT(std::abs(along(faces.faces[3].y, p)), 1);
        const float depth = 1 - along(faces.faces[3].z, p) / faces.depth_scale;
        EXPECT_GT(depth, 0);
        EXPECT_LT(depth, 1);
    }
}

/// The face of a light in whose middle a direction from it falls, by brute force; -1: none.
int face_seen_in(const LightFaces& faces, const vec3& p)
{
    for (std::size_t f = 0; f < faces.faces.size(); ++f) {
        const float z = along(faces.faces[f].z, p);
        const float inner = 1 / faces.faces[f].scale * 1.0001f; // half the angle without the guard band
        if (z > 0 && std::abs(along(faces.faces[f].x, p)) <= inner * z &&
            std::abs(along(faces.faces[f].y, p)) <= inner * z)
            return static_cast<int>(f);
    }
    return -1;
}

TEST(shadow_faces, a_cube_sees_everywhere_and_half_a_cube_all_in_front)
{
    Light point = default_light(LightType::point), rect = default_light(LightType::rect);
    point.position = rect.position = {1, 2, 3};
    rect.direction = {0.3f, -1, 0.5f};
    const LightFaces cube = light_faces(point, room, {}, 0), half = light_faces(rect, room, {}, 0);
    ASSERT_EQ(cube.faces.size(), 6u);
    ASSERT_EQ(half.faces.size(), 5u);
    for (std::uint32_t n = 0; n < 2000; ++n) {
        Light ball = point; // directions from a set of points that the light has anyway
        ball.position = vec3(0);
        ball.size = 1;
        const vec3 d = glm::normalize(at_point(ball, 1, n).position);
        EXPECT_GE(face_seen_in(cube, point.position + 2.0f * d), 0);
        if (glm::dot(d, glm::normalize(rect.direction)) > 0) {
            EXPECT_GE(face_seen_in(half, rect.position + 2.0f * d), 0);
        }
    }
    const std::vector<std::pair<vec3, int>> known{{{1, 0, 0}, 0},  {{-1, 0, 0}, 1}, {{0, 1, 0}, 2},
                                                  {{0, -1, 0}, 3}, {{0, 0, -1}, 4}, {{0, 0, 1}, 5}};
    for (const auto& [d, face] : known) EXPECT_EQ(face_seen_in(cube, point.position + d), face);
}

TEST(light_points, seen_from_anywhere_they_fill_the_disc_evenly)
{
    Light light = default_light(LightType::point);
    light.size = 0.5f;
    light.position = {1, 2, 3};
    constexpr std::uint32_t count = 4096;
    for (const vec3& axis : {vec3(1, 0, 0), vec3(0, 0, 1), glm::normalize(vec3(1, 2, -1))}) {
        const vec3 u = glm::normalize(glm::cross(axis, vec3(0.3f, 1, 0.1f))), v = glm::cross(axis, u);
        std::vector<int> rings(4), sectors(8);
        for (std::uint32_t n = 0; n < count; ++n) {
            const vec3 d = (at_point(light, 1, n).position - light.position) / light.size;
            const vec2 on(glm::dot(d, u), glm::dot(d, v));
            ASSERT_LE(glm::length(on), 1.00001f);
            ++rings[std::min<std::size_t>(3, static_cast<std::size_t>(4 * glm::dot(on, on)))]; // of equal areas
            ++sectors[static_cast<std::size_t>(8 * (std::atan2(on.y, on.x) / (2 * pi) + 0.5f)) % 8];
        }
        for (const int n : rings) EXPECT_NEAR(n, count / 4.0, count * 0.01);
        for (const int n : sectors) EXPECT_NEAR(n, count / 8.0, count * 0.01);
    }
}

TEST(light_points, of_a_rectangle_and_a_sun_stay_on_them)
{
    Light rect = default_light(LightType::rect), sun = default_light(LightType::sun);
    rect.width = 2;
    rect.height = 0.5f;
    sun.angle = 10;
    const LightAxes axes = axes_of(rect), sun_axes = axes_of(sun);
    vec2 low(1), high(-1);
    for (std::uint32_t n = 0; n < 500; ++n) {
        const vec3 d = at_point(rect, 1, n).position - rect.position;
        EXPECT_NEAR(glm::dot(d, axes.direction), 0, 1e-5f);
        const vec2 at(glm::dot(d, axes.right) / 1.0f, glm::dot(d, axes.up) / 0.25f);
        low = glm::min(low, at);
        high = glm::max(high, at);
        const float cosine = glm::dot(glm::normalize(at_point(sun, 1, n).direction), sun_axes.direction);
        EXPECT_LE(glm::degrees(std::acos(cosine)), 5.001f);
    }
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(low[i], -1, 0.02f);
        EXPECT_NEAR(high[i], 1, 0.02f);
    }
}

} // namespace
} // namespace atrium
