#include "assetconv/ear_clip.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace atrium {
namespace {

/// Sum of the triangles' signed areas along +z, and of their absolute ones: equal when nothing overlaps or is reversed.
struct Areas {
    double sum = 0, absolute = 0;
};

Areas areas(const std::vector<vec3>& polygon, const EarClipping& cut)
{
    Areas a;
    for (const auto& t : cut.triangles) {
        const glm::dvec3 p(polygon[t[0]]), q(polygon[t[1]]), r(polygon[t[2]]);
        const double area = 0.5 * glm::cross(q - p, r - p).z;
        a.sum += area;
        a.absolute += std::abs(area);
    }
    return a;
}

void expect_area(const std::vector<vec3>& polygon, double area)
{
    const EarClipping cut = clip_ears(polygon);
    EXPECT_TRUE(cut.simple);
    EXPECT_EQ(cut.triangles.size(), polygon.size() - 2);
    const Areas a = areas(polygon, cut);
    EXPECT_NEAR(a.sum, area, 1e-6 * area);
    EXPECT_NEAR(a.absolute, area, 1e-6 * area);
}

TEST(ear_clip, concave_polygons_keep_their_area)
{
    expect_area({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}, 16 - 6);                  // a notch
    expect_area({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, 5);            // an L
    expect_area({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}}, 4); // corners on lines
    expect_area({{2, 1, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}}, 16 - 6); // begins at the notch
}

TEST(ear_clip, a_comb_keeps_its_area)
{
    std::vector<vec3> comb{{0, 0, 0}, {40, 0, 0}};
    for (int tooth = 19; tooth >= 0; --tooth) {
        const float x = static_cast<float>(tooth) * 2;
        comb.insert(comb.end(), {{x + 1, 10, 0}, {x, 1, 0}});
    }
    // Between base line and the saw: the trapezoid rule along the top.
    double area = 0;
    for (std::size_t i = 0; i < comb.size(); ++i) {
        const vec3 &a = comb[i], &b = comb[(i + 1) % comb.size()];
        area += 0.5 * (double{a.x} * b.y - double{b.x} * a.y);
    }
    expect_area(comb, area);
}

TEST(ear_clip, a_ring_with_a_bridge_keeps_its_hole)
{
    // A square with a square hole, joined by a bridge walked twice.
    expect_area(
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}},
        16 - 4);
}

TEST(ear_clip, works_in_any_plane_and_far_away)
{
    for (const vec3& axis : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(0.57735f), vec3(-0.57735f)}) {
        const vec3 u =
            glm::normalize(std::abs(axis.x) < 0.9f ? glm::cross(axis, vec3(1, 0, 0)) : glm::cross(axis, vec3(0, 1, 0)));
        const vec3 v = glm::cross(axis, u);
        std::vector<vec3> polygon;
        for (const vec2& p : {vec2(0, 0), vec2(4, 0), vec2(4, 4), vec2(2, 1), vec2(0, 4)})
            polygon.push_back(vec3(1000, 2000, -500) + u * p.x + v * p.y);
        double area = 0;
        for (const auto& t : clip_ears(polygon).triangles) {
            const glm::dvec3 n = glm::cross(glm::dvec3(polygon[t[1]]) - glm::dvec3(polygon[t[0]]),
                                            glm::dvec3(polygon[t[2]]) - glm::dvec3(polygon[t[0]]));
            area += 0.5 * glm::dot(n, glm::dvec3(axis)); // wound as the polygon is
        }
        EXPECT_NEAR(area, 10, 1e-2); // positions of 32 bits, 2000 m away
    }
}

TEST(ear_clip, crossing_polygons_are_said_to_be_so_and_large_ones_end)
{
    EXPECT_FALSE(clip_ears(std::vector<vec3>{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 3, 0}}).simple);
    std::vector<vec3> spiral; // nearly every corner is reflex once the outer turns are gone
    for (int i = 0; i < 10000; ++i) {
        const float angle = static_cast<float>(i % 5000) * 0.05f, r = 1 + angle + (i < 5000 ? 0.0f : 0.1f);
        spiral.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    std::reverse(spiral.begin() + 5000, spiral.end());
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(clip_ears(spiral).triangles.size(), spiral.size() - 2);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

} // namespace
} // namespace atrium
