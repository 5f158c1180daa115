#include "renderer/scene/camera_path.hpp"

#include <gtest/gtest.h>

namespace atrium {
namespace {

const Camera other{{9, 9, 9}, {0, 0, 0}, 35};

TEST(camera_path, passes_through_its_keys_and_stands_still_outside)
{
    const CameraPath path{{1, {0, 0, 0}, {0, 0, 1}}, {2, {4, 1, 0}, {4, 0, 5}}, {4, {5, 3, 2}, {1, 1, 1}}};
    for (const CameraKey& key : path) {
        const Camera camera = camera_at(path, key.time, other);
        EXPECT_EQ(camera.eye, key.eye);
        EXPECT_EQ(camera.target, key.target);
        EXPECT_EQ(camera.fov, other.fov);
    }
    EXPECT_EQ(camera_at(path, -3, other).eye, path.front().eye);
    EXPECT_EQ(camera_at(path, 7, other).eye, path.back().eye);
    EXPECT_EQ(camera_at({}, 1, other), other);
}

TEST(camera_path, of_even_keys_on_a_line_is_a_steady_walk)
{
    CameraPath path;
    for (int i = 0; i < 5; ++i) {
        const auto x = static_cast<float>(i);
        path.push_back({2 * x, {3 * x, 1, 0}, {3 * x, 1, -1}});
    }
    for (const float time : {2.5f, 3.0f, 4.2f, 5.9f})
        EXPECT_NEAR(camera_at(path, time, other).eye.x, 1.5f * time, 1e-5f) << time;
}

TEST(camera_path, looks_somewhere_where_eye_and_target_change_places)
{
    const CameraPath path{{0, {0, 0, 0}, {2, 0, 0}}, {2, {2, 0, 0}, {0, 0, 0}}};
    const Camera camera = camera_at(path, 1, other);
    EXPECT_NE(camera.eye, camera.target);
}

} // namespace
} // namespace atrium
