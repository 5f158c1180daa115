#include "app/gui/camera_paths.hpp"

#include "app/gui/path_overlay.hpp"
#include "app/gui/path_panel.hpp"
#include "tests/gui/headless.hpp"

#include <gtest/gtest.h>

namespace atrium::gui {
namespace {

const Camera here{{1, 2, 3}, {4, 5, 6}, 70};

Camera at(float x)
{
    return {{x, 0, 0}, {x, 0, -1}, 60};
}

TEST(camera_paths, begin_with_one_key_and_no_name_stands_twice)
{
    CameraPaths paths;
    std::string name;
    EXPECT_EQ(add_path(paths, name, here), std::nullopt);
    EXPECT_EQ(name, "path0");
    EXPECT_EQ(paths.at("path0"), (CameraPath{{0, here.eye, here.target}}));
    EXPECT_TRUE(add_path(paths, name, here).has_value());
    EXPECT_EQ(paths.size(), 1u);
}

TEST(camera_paths, keys_are_kept_in_order_and_no_time_stands_twice)
{
    CameraPath path;
    EXPECT_EQ(add_key(path, 2, at(2)), 0u);
    EXPECT_EQ(add_key(path, 5, at(5)), 1u);
    EXPECT_EQ(add_key(path, -1, at(-1)), 0u);
    EXPECT_EQ(add_key(path, 3, at(3)), 2u);
    EXPECT_EQ(add_key(path, 3, here), std::nullopt);
    ASSERT_EQ(path.size(), 4u);
    for (const CameraKey& key : path) EXPECT_EQ(key.eye.x, key.time);
}

TEST(camera_paths, a_player_goes_to_the_end_and_begins_again)
{
    const CameraPath path{{1, {1, 0, 0}, {1, 0, -1}}, {3, {3, 0, 0}, {3, 0, -1}}};
    Camera camera = here;
    PathPlayer player;
    EXPECT_FALSE(player.advance(path, 1, camera));
    EXPECT_EQ(camera, here);
    player.play(path);
    EXPECT_TRUE(player.advance(path, 1, camera));
    EXPECT_EQ(player.time, 2);
    EXPECT_NEAR(camera.eye.x, 2, 1e-6);
    EXPECT_EQ(camera.fov, here.fov);
    EXPECT_TRUE(player.advance(path, 9, camera)); // the last step
    EXPECT_FALSE(player.playing);
    EXPECT_EQ(camera.eye.x, 3);
    EXPECT_FALSE(player.advance(path, 1, camera));
    player.play(path);
    EXPECT_EQ(player.time, 1);
}

TEST(camera_paths, a_path_that_was_removed_is_not_played)
{
    ViewModel model;
    PathPanel panel;
    std::string name;
    ASSERT_EQ(add_path(model.paths, name, here), std::nullopt);
    panel.path = 0;
    panel.player.playing = true;
    model.paths.clear();
    EXPECT_FALSE(play_path(model, panel, 1));
    EXPECT_FALSE(panel.path.has_value());
}

TEST(camera_paths, are_drawn_where_they_are_in_view)
{
    const test::HeadlessGui gui(800, 600);
    const CameraPath path{{0, {-1, 0, -5}, {-1, 0, -9}}, {1, {1, 0, -5}, {1, 0, -9}}};
    const auto vertices = [&](const CameraPath& drawn, const Camera& camera) {
        gui.frame([&] { draw_path(drawn, 0, Projection(camera, {800, 600}), 1); });
        return gui.vertices();
    };
    const int none = vertices({}, at(0));
    EXPECT_GT(vertices(path, at(0)), none + 100);
    EXPECT_EQ(vertices(path, {{0, 0, -20}, {0, 0, -30}, 60}), none); // behind the camera
}

} // namespace
} // namespace atrium::gui
