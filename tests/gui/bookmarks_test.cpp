#include "app/gui/bookmarks.hpp"

#include "app/view/window_state.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace atrium::gui {
namespace {

const Camera here{{1, 2, 3}, {4, 5, 6}, 70};

TEST(bookmarks, no_name_stands_twice)
{
    Bookmarks bookmarks;
    EXPECT_FALSE(add_bookmark(bookmarks, "door", here).has_value());
    EXPECT_TRUE(add_bookmark(bookmarks, "door", here).has_value());
    EXPECT_FALSE(add_bookmark(bookmarks, "camera2", here).has_value());
    EXPECT_FALSE(add_bookmark(bookmarks, "", here).has_value());
    ASSERT_EQ(bookmarks.size(), 3u);
    EXPECT_EQ(bookmarks[2].first, "camera3"); // the first that is free from their number on
    EXPECT_TRUE(rename_bookmark(bookmarks, 0, "camera2").has_value());
    EXPECT_TRUE(rename_bookmark(bookmarks, 0, "").has_value());
    EXPECT_FALSE(rename_bookmark(bookmarks, 0, "door").has_value());
    EXPECT_FALSE(rename_bookmark(bookmarks, 0, "gate").has_value());
    EXPECT_EQ(bookmarks[0], NamedCamera("gate", here));
}

TEST(bookmarks, come_back_with_the_window_for_each_scene)
{
    const auto file = std::filesystem::temp_directory_path() / ("state-" + std::to_string(getpid()) + ".toml");
    app::WindowState state;
    state.scene = "/a \"scene\"";
    state.camera = here;
    state.settings_file = "mine.toml";
    state.bookmarks["/a"] = {{"a \\ \"door\"", here}, {"überall", {{-1e-3f, 0, 1e6f}, {0, 0, 0}, 1.5f}}};
    state.bookmarks["/b"] = {{"door", {}}};
    state.recent = {"/b", "/a"};
    app::write_window_state(file, state);
    EXPECT_EQ(app::read_window_state(file), state);
    std::filesystem::remove(file);
}

} // namespace
} // namespace atrium::gui
