// Edges lie where the camera sees them, and nowhere else.

#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

namespace atrium {
namespace {

/// A square of 2 m, and behind it a smaller one that it hides.
BakeData two_squares()
{
    truth::SceneBuilder builder;
    const std::uint32_t grey = builder.add_material("grey");
    builder.add_mesh("front", grey, truth::quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
    builder.add_mesh("behind", grey, truth::quad({-0.5f, -0.5f, -1}, {1, 0, 0}, {0, 1, 0}));
    return builder.finish();
}

float distance_to(const vec2& p, const std::pair<vec2, vec2>& edge)
{
    const vec2 along = edge.second - edge.first;
    const float t = std::clamp(glm::dot(p - edge.first, along) / glm::dot(along, along), 0.0f, 1.0f);
    return glm::length(p - edge.first - t * along);
}

TEST(wireframe, edges_lie_where_the_camera_sees_them)
{
    rig::FrameRig rig(two_squares());
    rig.look({0, 0, 4}, {0, 0, 0}, 60);
    rig.request.want_picture = true;
    const Image8 without = rig.render().picture;
    rig.set("debug.wireframe", "on");
    const Image8 with = rig.render().picture;

    // Half the square's side in pixels: 1 m at 4 m, 180 pixels over twice tan(30 degrees).
    const float half = 0.25f * 90.0f / std::tan(glm::radians(30.0f));
    const vec2 middle(160, 90);
    const vec2 a = middle + vec2(-half, half), b = middle + vec2(half, half), c = middle + vec2(half, -half),
               d = middle + vec2(-half, -half);
    std::array<std::pair<vec2, vec2>, 4> sides{{{a, b}, {b, c}, {c, d}, {d, a}}};
    std::array<int, 2> on_diagonal{};
    int away = 0, on_sides = 0;
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 320; ++x) {
            if (std::equal(with.at(x, y), with.at(x, y) + 3, without.at(x, y))) continue;
            const vec2 p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const bool side =
                std::any_of(sides.begin(), sides.end(), [&](const auto& s) { return distance_to(p, s) < 1.5f; });
            const bool first = distance_to(p, {a, c}) < 1.5f, second = distance_to(p, {b, d}) < 1.5f;
            on_sides += side ? 1 : 0;
            on_diagonal[0] += first && !side ? 1 : 0;
            on_diagonal[1] += second && !side ? 1 : 0;
            away += side || first || second ? 0 : 1;
        }
    }
    EXPECT_EQ(away, 0); // nothing of the square behind
    EXPECT_GT(on_sides, static_cast<int>(4 * 2 * half * 0.9f));
    EXPECT_GT(std::max(on_diagonal[0], on_diagonal[1]), static_cast<int>(2 * half * 0.9f));
    EXPECT_LT(std::min(on_diagonal[0], on_diagonal[1]), 5); // one of them only, and where they cross
}

} // namespace
} // namespace atrium
