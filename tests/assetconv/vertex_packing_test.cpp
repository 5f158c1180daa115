#include "renderer/scene/vertex_packing.hpp"

#include <gtest/gtest.h>

#include <random>

namespace atrium {
namespace {

float angle_degrees(const vec3& a, const vec3& b)
{
    const glm::dvec3 x(a), y(b);
    return static_cast<float>(glm::degrees(std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y))));
}

vec3 random_direction(std::mt19937& random)
{
    std::normal_distribution<float> normal;
    return glm::normalize(vec3(normal(random), normal(random), normal(random)));
}

TEST(vertex_packing, normals_come_back_within_four_thousandths_of_a_degree)
{
    std::mt19937 random(1);
    float worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const vec3 n = random_direction(random);
        worst = std::max(worst, angle_degrees(n, unpack_normal(pack_normal(n))));
    }
    EXPECT_LT(worst, 0.004f); // half a step of 2/65535 on the octahedron, stretched: measured 0.0030
    EXPECT_GT(worst, 0.001f);
}

TEST(vertex_packing, tangents_keep_direction_and_handedness)
{
    std::mt19937 random(2);
    for (int i = 0; i < 20000; ++i) {
        const vec3 t = random_direction(random);
        const float w = i % 2 == 0 ? 1.0f : -1.0f;
        const vec4 back = unpack_tangent(pack_tangent(t, w));
        EXPECT_LT(angle_degrees(t, vec3(back)), 0.006f);
        EXPECT_EQ(back.w, w);
    }
}

TEST(vertex_packing, axes_and_the_fold_are_exact_enough)
{
    for (const vec3& n :
         {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
        EXPECT_LT(angle_degrees(n, unpack_normal(pack_normal(n))), 0.004f);
    }
    // On the lower half zero counts as positive: (0, 0, -1) sits in the corner (1, 1), not in the middle.
    EXPECT_EQ(octahedral_encode({0, 0, -1}), vec2(1, 1));
    EXPECT_EQ(pack_normal({0, 0, -1}), 0xffffffffu);
}

} // namespace
} // namespace atrium
