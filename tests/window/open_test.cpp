// Other scenes, dropped on the window or chosen in its dialog.

#include "tests/window/tabs.hpp"
#include "tests/window/viewed.hpp"

#include <string>

namespace atrium::window {
namespace {

class OpenedScenes : public ViewedProgram {
protected:
    static void SetUpTestSuite()
    {
        ViewedProgram::SetUpTestSuite();
        fs::create_directories(folder / "atrium");
        std::ofstream(folder / "atrium" / "window.toml") << damaged_state;
        start(hero());
    }
    static fs::path court(const char* file) { return folder / "courtyard" / file; }
    /// Whether the window names the file, once it is drawn.
    static bool shows(const std::string& file) { return desktop->find("Atrium: " + file, 60s) == window && settle(); }
    /// Opens the courtyard's scene file where another is shown, and looks at it as in the beginning.
    static Image8 back_in_the_court()
    {
        if (desktop->find("Atrium: courtyard.toml", 0s) != window) {
            EXPECT_TRUE(desktop->drop(window, court("courtyard.toml")));
        }
        EXPECT_TRUE(shows("courtyard.toml"));
        return scene();
    }
    static inline const std::string damaged_state = "[[bookmark]]\nscene = \"/a\"\nname = \"door\"\neye = nowhere\n";
};

TEST_F(OpenedScenes, a_damaged_memory_is_kept_and_told_of)
{
    EXPECT_EQ(bytes_of(folder / "atrium" / "window.toml.damaged"), damaged_state);
    EXPECT_FALSE(fs::exists(folder / "atrium" / "window.toml"));
    EXPECT_TRUE(says("window.toml.damaged: mend it"));
}

TEST_F(OpenedScenes, an_obj_that_is_dropped_is_baked_and_shown)
{
    const Image8 start = back_in_the_court();
    ASSERT_TRUE(desktop->drop(window, court("courtyard.obj")));
    ASSERT_TRUE(shows("courtyard.obj"));
    EXPECT_GT(mean_difference(start, scene()), 3); // a camera of its own, no lanterns
    EXPECT_EQ(mean_difference(start, back_in_the_court()), 0);
}

TEST_F(OpenedScenes, a_bake_can_be_cancelled_and_the_window_goes_on_meanwhile)
{
    {
        std::ofstream obj(folder / "field.obj"); // the same triangles again and again: many seconds of work
        std::string rows, triangles;
        for (int i = 0; i < 1000; ++i) rows += "v " + std::to_string(i) + " 0 0\nv " + std::to_string(i) + " 0 1\n";
        for (int i = 1; i < 1999; ++i) triangles += "f " + std::to_string(i) + ' ' + std::to_string(i + 1) + " 2000\n";
        obj << rows;
        for (int i = 0; i < 2000; ++i) obj << triangles;
    }
    const Image8 before = desktop->grab(window);
    ASSERT_TRUE(desktop->drop(window, folder / "field.obj"));
    std::this_thread::sleep_for(500ms);
    const Image8 noted = desktop->grab(window);
    EXPECT_GT(mean_difference(before, noted), 0.05);
    desktop->tap("F1");
    std::this_thread::sleep_for(500ms);
    EXPECT_GT(mean_difference(noted, desktop->grab(window)), 1); // without its panels
    desktop->tap("F1");
    const double cpu = program->cpu_seconds();
    std::this_thread::sleep_for(500ms);
    EXPECT_LT(program->cpu_seconds() - cpu, 0.25); // the panels that come back are drawn, the scene is not
    desktop->click(window, {406, 72});             // the note's button
    std::this_thread::sleep_for(300ms);            // is seen where the mouse is then
    desktop->move(window, {850, 500});
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(before, desktop->grab(window)), 0);
    for (const auto& bake : fs::directory_iterator(folder / "atrium" / "bakes"))
        EXPECT_TRUE(bake.path().filename().string().starts_with("courtyard")) << bake.path();
}

TEST_F(OpenedScenes, what_cannot_be_opened_leaves_the_scene)
{
    const Image8 start = back_in_the_court();
    std::ofstream(folder / "broken.toml") << "bake = 3\n";
    std::ofstream(folder / "broken.obj") << "v 0 0 0\nf 1 2 9\n";
    std::ofstream(folder / "broken.atrium") << "no bake";
    std::ofstream(folder / "picture.png") << "no scene";
    fs::create_directories(folder / "empty");
    const Image8 quiet = desktop->grab(window);
    for (const char* file : {"broken.toml", "broken.obj", "broken.atrium", "picture.png", "empty", "missing.obj"}) {
        const std::size_t said = log().size();
        ASSERT_TRUE(desktop->drop(window, folder / file)) << file;
        const auto refused = [&] { return log().find("  next:", said) != std::string::npos; };
        for (int i = 0; i < 100 && !refused(); ++i) std::this_thread::sleep_for(100ms);
        ASSERT_TRUE(settle());
        const std::string message = log().substr(said);
        for (const char* part : {file, "  where:", "  why:", "  next:"})
            EXPECT_NE(message.find(part), std::string::npos) << part << " in " << message;
        EXPECT_EQ(mean_difference(start, scene()), 0) << file;
        EXPECT_GT(mean_difference(quiet, desktop->grab(window)), 0.1) << file; // the panels tell
    }
}

TEST_F(OpenedScenes, what_is_shown_of_a_light_goes_with_it)
{
    static_cast<void>(back_in_the_court());
    desktop->click(window, tabs::buffers);
    ASSERT_TRUE(settle());
    desktop->click(window, {180, 168}); // the search box
    type("visibility.sun");
    ASSERT_TRUE(settle());
    EXPECT_GT(change([] { desktop->click(window, {35, 230}); }), 1); // pins it
    desktop->tap("F1");
    ASSERT_TRUE(desktop->drop(window, court("courtyard.atrium"))); // which has one light, of another name
    ASSERT_TRUE(shows("courtyard.atrium"));
    desktop->tap("o", "Control_L");
    ASSERT_TRUE(settle());
    type("missing.obj");
    desktop->tap("Return"); // is refused, which shows the panels again
    EXPECT_TRUE(settle());
    EXPECT_TRUE(program->running());
}

TEST_F(OpenedScenes, a_path_is_typed_and_completed)
{
    fs::copy(court("courtyard.atrium"), folder / "other.atrium");
    desktop->tap("o", "Control_L");
    ASSERT_TRUE(settle());
    type("oth");
    desktop->tap("Tab");
    desktop->tap("Return");
    EXPECT_TRUE(shows("other.atrium"));
}

TEST_F(OpenedScenes, each_begins_anew_and_keeps_its_bookmarks)
{
    static_cast<void>(back_in_the_court());
    desktop->click(window, tabs::camera);
    ASSERT_TRUE(settle());
    desktop->click(window, {158, 342}); // the name of a new bookmark
    desktop->tap("b");
    desktop->tap("Return");
    ASSERT_TRUE(settle());
    EXPECT_GT(change([] { desktop->tap("n"); }), 0.02);
    ASSERT_TRUE(desktop->drop(window, court("courtyard.atrium")));
    ASSERT_TRUE(shows("courtyard.atrium"));
    EXPECT_EQ(change([] { desktop->tap("z", "Control_L"); }), 0); // it was the other scene's step
}

TEST_F(OpenedScenes, many_after_each_other_take_no_more_memory)
{
    std::uint64_t memory = 0;
    for (int i = 0; i < 6; ++i) {
        const char* file = i % 2 ? "courtyard.toml" : "courtyard.atrium";
        ASSERT_TRUE(desktop->drop(window, court(file)));
        ASSERT_TRUE(shows(file));
        if (i == 1) memory = program->resident_bytes();
    }
    RecordProperty("grown_bytes", std::to_string(static_cast<std::int64_t>(program->resident_bytes() - memory)));
    EXPECT_LT(program->resident_bytes(), memory + (16u << 20)); // a fraction of what one scene takes
    desktop->close(window);
    EXPECT_EQ(program->wait(20s), std::optional(0)); // 5: validation had something to say
    const std::string state = bytes_of(folder / "atrium" / "window.toml");
    const std::string scene_line = "scene = \"" + court("courtyard.toml").string() + "\"\n";
    EXPECT_NE(state.find("[[recent]]\n" + scene_line), std::string::npos);
    EXPECT_NE(state.find("[[bookmark]]\n" + scene_line + "name = \"b\""), std::string::npos);
    EXPECT_NE(state.find(court("courtyard.obj").string()), std::string::npos);
}

} // namespace
} // namespace atrium::window
