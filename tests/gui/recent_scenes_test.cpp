// What a window remembers of scenes, and that it does not lose it.

#include "app/view/recent_scenes.hpp"
#include "app/view/window_state.hpp"
#include "renderer/core/error.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

namespace atrium::app {
namespace {

namespace fs = std::filesystem;

TEST(recent_scenes, the_newest_stands_first_and_once)
{
    std::vector<fs::path> recent;
    for (int i = 0; i < 12; ++i) remember_scene(recent, fs::path("/") / std::to_string(i));
    remember_scene(recent, "/5");
    ASSERT_EQ(recent.size(), 10u);
    EXPECT_EQ(recent[0], "/5");
    EXPECT_EQ(recent[1], "/11");
    EXPECT_EQ(recent[9], "/2");
}

TEST(recent_scenes, a_scene_has_one_path)
{
    EXPECT_EQ(scene_path("a/../b.toml"), fs::current_path() / "b.toml");
    EXPECT_EQ(scene_path("/x/./b.toml"), "/x/b.toml");
}

TEST(recent_scenes, names_that_are_no_utf8_do_not_damage_the_file)
{
    const fs::path file = fs::temp_directory_path() / ("atrium-names-" + std::to_string(getpid()) + ".toml");
    WindowState state, kept;
    state.recent = {"/a\xff.obj", "/b.obj"};
    kept.recent = {"/b.obj"};
    state.scene = "/a\xff.obj";
    state.bookmarks["/a\xff.obj"] = {{"door", {}}};
    state.bookmarks["/b.obj"] = kept.bookmarks["/b.obj"] = {{"gate", {}}};
    write_window_state(file, state);
    EXPECT_EQ(read_window_state(file), kept);
    fs::remove(file);
}

TEST(recent_scenes, a_damaged_file_is_kept_under_another_name)
{
    const fs::path folder = fs::temp_directory_path() / ("atrium-state-" + std::to_string(getpid()));
    const fs::path file = folder / "window.toml", aside = folder / "window.toml.damaged";
    fs::create_directories(folder);
    for (const std::string damage : {"x = = 3\n", "bookmark = 3\n", "eye = [0, 0]\n", "\xff\n"}) {
        std::ofstream(file) << damage;
        try {
            static_cast<void>(read_window_state(file));
            ADD_FAILURE() << damage;
        } catch (const Error& error) {
            EXPECT_NE(error.next().find(aside.string()), std::string::npos) << error.text();
        }
        EXPECT_FALSE(fs::exists(file));
        std::ifstream in(aside);
        EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), damage);
    }
    fs::remove_all(folder);
}

} // namespace
} // namespace atrium::app
