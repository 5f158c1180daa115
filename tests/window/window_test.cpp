// The window on a real X server, moved by real keys and clicks.

#include "tests/window/tabs.hpp"
#include "tests/window/viewed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

namespace atrium::window {
namespace {

Image8 part(const Image8& whole, ivec2 from, ivec2 to)
{
    Image8 out(to.x - from.x, to.y - from.y, 3);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) std::copy_n(whole.at(from.x + x, from.y + y), 3, out.at(x, y));
    return out;
}

class Viewed : public ViewedProgram {
protected:
    static void SetUpTestSuite()
    {
        ViewedProgram::SetUpTestSuite();
        fs::create_directories(folder / "atrium");
        std::ofstream(folder / "atrium" / "keys.toml") << "normal_mapping = 'K'\n";
        std::vector<std::string> options = hero();
        options.insert(options.end(), {"--set", "shadow.reference_points=32"});
        start(options);
    }
};

TEST_F(Viewed, shows_what_render_draws)
{
    const fs::path file = folder / "headless.png";
    const std::string command = std::string(ATRIUM_BIN) + "/atrium render " +
                                (folder / "courtyard" / "courtyard.toml").string() + " --camera hero --size " +
                                std::to_string(window_size.x) + "x" + std::to_string(window_size.y) +
                                " --set ao.method=gtao -o " + file.string() + " --quiet";
    ASSERT_EQ(std::system(command.c_str()), 0);
    picture("window");
    desktop->tap("F1"); // panels and handles
    EXPECT_TRUE(settle());
    EXPECT_LE(mean_difference(desktop->grab(window), read_png(file)), 0.01); // encoded, decoded and encoded again
    desktop->tap("F1");
    EXPECT_TRUE(settle());
}

TEST_F(Viewed, keys_change_techniques_and_undo_takes_it_back)
{
    for (const char* key : {"p", "o", "k"}) { // k: by the file of keys
        const Image8 start = scene();
        EXPECT_GT(change([&] { desktop->tap(key); }), 0.02) << key;
        EXPECT_GT(change([] { desktop->tap("z", "Control_L"); }), 0.02) << key;
        EXPECT_EQ(mean_difference(start, scene()), 0) << key;
    }
}

TEST_F(Viewed, the_selected_light_follows_ctrl_and_drag)
{
    desktop->click(window, tabs::lights);
    ASSERT_TRUE(settle());
    desktop->click(window, {100, 224}); // the second of the list, a lantern
    ASSERT_TRUE(settle());
    const Image8 start = scene();
    EXPECT_GT(change([] {
                  desktop->press("Control_L");
                  desktop->drag(window, {650, 300}, {750, 380});
                  desktop->release("Control_L");
              }),
              0.02);
    EXPECT_GT(change([] { desktop->tap("z", "Control_L"); }), 0.02);
    EXPECT_EQ(mean_difference(start, scene()), 0); // the view has not turned with it
}

TEST_F(Viewed, a_split_view_shows_two_settings_with_a_divider)
{
    const ivec2 split_view{192, 280}, one_view{48, 308};
    desktop->click(window, tabs::settings);
    ASSERT_TRUE(settle());
    const Image8 whole = desktop->grab(window);
    desktop->click(window, split_view);
    ASSERT_TRUE(settle());
    desktop->tap("o"); // of the right side: ambient occlusion by another method
    ASSERT_TRUE(settle());
    const Image8 halves = desktop->grab(window);
    const ivec2 left_from{panel + 4, 60}, middle{(388 + window_size.x) / 2, 60}, farther{780, 60};
    const auto differ = [&](const Image8& other, ivec2 from, int to) {
        return mean_difference(part(whole, from, {to - 12, window_size.y}),
                               part(other, from, {to - 12, window_size.y}));
    };
    EXPECT_EQ(differ(halves, left_from, middle.x), 0);
    EXPECT_GT(differ(halves, middle + ivec2(12, 0), window_size.x), 0.1);
    picture("window-split");

    desktop->drag(window, {middle.x, 400}, {farther.x, 400}, 1);
    ASSERT_TRUE(settle());
    const Image8 moved = desktop->grab(window);
    EXPECT_EQ(differ(moved, middle + ivec2(12, 0), farther.x), 0);
    EXPECT_GT(differ(moved, farther + ivec2(12, 0), window_size.x), 0.1);

    desktop->click(window, one_view);
    desktop->tap("z", "Control_L");
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(scene_part(whole), scene()), 0);
}

TEST_F(Viewed, bookmarks_are_kept_and_gone_to)
{
    desktop->click(window, tabs::camera);
    ASSERT_TRUE(settle());
    const ivec2 field{158, 342}, hero{70, 375}, fountain{70, 395}, bookmark{70, 495}; // lines of the list
    const Image8 start = scene();
    EXPECT_GT(change([&] { desktop->click(window, fountain); }), 3);
    const Image8 there = scene();
    desktop->click(window, field);
    desktop->tap("b");
    desktop->tap("Return");
    ASSERT_TRUE(settle());
    EXPECT_GT(change([&] { desktop->click(window, hero); }), 3);
    EXPECT_EQ(mean_difference(start, scene()), 0);
    EXPECT_GT(change([&] { desktop->click(window, bookmark); }), 3);
    EXPECT_EQ(mean_difference(there, scene()), 0);
    EXPECT_GT(change([&] { desktop->click(window, hero); }), 3);
}

TEST_F(Viewed, a_camera_path_is_made_played_and_saved)
{
    desktop->resize(window, {window_size.x, 860}); // so that all of the tab is in view, at y:
    const int new_path = 541, play = 615, keys = 649, key_line = 20, add = 709, remove = 737, save = 765;
    const ivec2 hero{70, 375}, fountain{70, 395}, relief{70, 455};
    const auto click = [](ivec2 at) {
        desktop->click(window, at);
        EXPECT_TRUE(settle());
    };
    ASSERT_TRUE(settle());
    click(fountain);
    click({37, new_path}); // without a name, it gets one
    click(relief);
    click({50, add - key_line}); // the list of keys has one line yet
    click(hero);
    picture("window-path");
    click({70, keys + key_line}); // the second key
    const Image8 there = scene();
    EXPECT_GT(change([&] { desktop->click(window, {70, keys}); }), 3);
    click({38, play});
    EXPECT_EQ(mean_difference(there, scene()), 0); // at its end

    click({58, save});
    const std::string command = "cd " + folder.string() + " && " + ATRIUM_BIN +
                                "/atrium render scene.toml --path path0 --frames 2 --size 32x18 -o w.#.png --quiet";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_TRUE(fs::exists(folder / "w.1.png"));
    click({60, 817}); // puts the message away
    click({290, remove});
    click(hero);
    desktop->resize(window, window_size);
    ASSERT_TRUE(settle());
}

TEST_F(Viewed, a_light_s_mark_is_clicked_and_dragged)
{
    const ivec2 mark{744, 281}, beside{700, 330};
    desktop->click(window, tabs::lights);
    desktop->click(window, mark);
    desktop->move(window, {850, 500});
    ASSERT_TRUE(settle());
    picture("window-lights");
    const Image8 start = scene();
    EXPECT_GT(change([&] { desktop->drag(window, mark, beside); }), 0.02);
    EXPECT_GT(change([] { desktop->tap("z", "Control_L"); }), 0.02);
    desktop->move(window, {850, 500});
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(start, scene()), 0);
}

TEST_F(Viewed, buffers_take_the_place_of_the_picture_and_stand_beside_it)
{
    desktop->click(window, tabs::buffers);
    ASSERT_TRUE(settle());
    const Image8 whole = scene();
    EXPECT_GT(change([] { desktop->click(window, {35, 230}); }), 1);    // pins depth
    EXPECT_GT(change([] { desktop->click(window, {35, 290}); }), 1);    // and the normal
    EXPECT_GT(change([] { desktop->click(window, {470, 430}); }), 3);   // enlarges it
    EXPECT_GT(change([] { desktop->move(window, {600, 250}); }), 0.01); // the value under the mouse
    picture("window-buffers");
    const double before = program->cpu_seconds();
    std::this_thread::sleep_for(1s);
    EXPECT_LT(program->cpu_seconds() - before, 0.05);    // rests with buffers too
    EXPECT_GT(change([] { desktop->tap("comma"); }), 3); // before depth is the picture
    EXPECT_GT(change([] { desktop->click(window, {35, 290}); }), 1);
    EXPECT_GT(change([] { desktop->click(window, {35, 230}); }), 1);
    EXPECT_EQ(mean_difference(whole, scene()), 0);
}

TEST_F(Viewed, images_of_the_graph_are_clicked_into_the_view)
{
    desktop->resize(window, {1200, 760}); // to see more of it
    ASSERT_TRUE(settle());
    desktop->click(window, tabs::buffers);
    ASSERT_TRUE(settle());
    const ivec2 frame_graph{198, 196}, albedo{805, 186}, id{805, 231};
    const Image8 start = scene();
    desktop->tap("period"); // there and back: shadow maps are kept then, and the graph has no passes for them
    desktop->tap("comma");
    ASSERT_TRUE(settle());
    desktop->click(window, frame_graph);
    ASSERT_TRUE(settle());
    desktop->drag(window, {1000, 400}, {620, 310}); // past the passes that cull, to the G-buffer
    EXPECT_GT(change([&] { desktop->click(window, albedo); }), 1);
    EXPECT_GT(change([&] { desktop->click(window, id); }), 1);
    picture("window-graph");
    EXPECT_GT(change([&] { desktop->click(window, id, 3); }), 3); // large
    desktop->click(window, id, 3);
    for (const ivec2 image : {albedo, id}) EXPECT_GT(change([&] { desktop->click(window, image); }), 1);
    desktop->tap("F2");
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(start, scene()), 0);
    desktop->resize(window, window_size);
    ASSERT_TRUE(settle());
}

TEST_F(Viewed, a_click_counts_however_quick)
{
    for (const ivec2 tab : {tabs::lights, tabs::camera, tabs::help, tabs::settings}) {
        const Image8 before = desktop->grab(window);
        desktop->move(window, tab);
        desktop->button(1, true);
        desktop->button(1, false);
        EXPECT_TRUE(settle());
        EXPECT_GT(mean_difference(before, desktop->grab(window)), 0.5) << tab.x; // more than its name lights up
    }
}

TEST_F(Viewed, l_looks_through_the_selected_light_and_back)
{
    const Image8 start = scene();
    EXPECT_GT(change([] { desktop->tap("l"); }), 3);
    EXPECT_GT(change([] { desktop->tap("l"); }), 3);
    EXPECT_EQ(mean_difference(start, scene()), 0);
}

TEST_F(Viewed, a_screenshot_is_drawn_again_to_the_byte)
{
    const Image8 start = scene();
    for (const std::string name : {"atrium.0000", "atrium.0001"}) { // of the picture, and of a buffer in its place
        desktop->tap("F12");
        for (const char* ending : {".png", ".exr"}) // the PNG comes last
            EXPECT_TRUE(is_drawn_again(folder / (name + ending))) << name << ending;
        desktop->tap("period");
        ASSERT_TRUE(settle());
    }
    EXPECT_GT(mean_difference(read_png(folder / "atrium.0000.png"), read_png(folder / "atrium.0001.png")), 3);
    desktop->tap("comma");
    EXPECT_GT(change([] { desktop->tap("comma"); }), 3);
    EXPECT_EQ(mean_difference(start, scene()), 0);
}

TEST_F(Viewed, v_writes_what_shadows_approximate_and_by_how_much)
{
    const Image8 before = scene();
    desktop->tap("v");
    const fs::path filtered = folder / "atrium.0000.filtered.png", reference = folder / "atrium.0000.reference.png",
                   difference = folder / "atrium.0000.difference.png";
    for (int i = 0; i < 300 && !fs::exists(difference); ++i) std::this_thread::sleep_for(100ms); // the last
    ASSERT_TRUE(fs::exists(difference));
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(before, scene()), 0);
    const double differs = mean_difference(read_png(filtered), read_png(reference));
    EXPECT_GT(differs, 0.01);
    const Image8 amplified = read_png(difference);
    EXPECT_NEAR(mean_difference(amplified, Image8(amplified.width, amplified.height, 3)), 4 * differs, differs);
}

TEST_F(Viewed, panels_hide_and_come_back)
{
    const Image8 with = desktop->grab(window);
    desktop->tap("F1");
    ASSERT_TRUE(settle());
    const Image8 without = desktop->grab(window);
    EXPECT_GT(mean_difference(with, without), 1);
    desktop->tap("F1");
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(with, desktop->grab(window)), 0);
    desktop->tap("h");
    ASSERT_TRUE(settle());
    EXPECT_GT(mean_difference(with, desktop->grab(window)), 0.5);
}

TEST_F(Viewed, rests_when_nothing_changes)
{
    ASSERT_TRUE(settle());
    const double before = program->cpu_seconds();
    std::this_thread::sleep_for(4s);
    EXPECT_LT((program->cpu_seconds() - before) / 4, 0.05);
}

TEST_F(Viewed, bears_sizes_minimising_and_full_screen)
{
    std::mt19937 random(3);
    std::uniform_int_distribution<int> width(320, 1200), height(200, 800);
    std::uint64_t memory = 0;
    for (int i = 0; i < 200; ++i) {
        desktop->resize(window, {width(random), height(random)});
        std::this_thread::sleep_for(10ms);
        ASSERT_TRUE(program->running()) << i;
        if (i == 40) {
            ASSERT_TRUE(settle());
            memory = program->resident_bytes();
        }
    }
    desktop->resize(window, window_size);
    ASSERT_TRUE(settle());
    EXPECT_LT(program->resident_bytes(), memory + (64u << 20));
    const Image8 before = desktop->grab(window);

    desktop->minimise(window);
    std::this_thread::sleep_for(500ms);
    const double cpu = program->cpu_seconds();
    std::this_thread::sleep_for(1s);
    EXPECT_LT(program->cpu_seconds() - cpu, 0.05); // rests while it is not seen
    desktop->restore(window);
    EXPECT_TRUE(comes_back_to(before));

    desktop->focus(window);
    desktop->tap("F11");
    ASSERT_TRUE(settle());
    EXPECT_EQ(desktop->size_of(window), ivec2(1280, 900));
    desktop->tap("F11");
    ASSERT_TRUE(settle());
    EXPECT_EQ(desktop->size_of(window), window_size);
}

// After those that measure what one camera sees: where it comes to rest depends on how fast frames are.
TEST_F(Viewed, flies_while_keys_are_held)
{
    const Image8 start = scene();
    const double moved = change([] {
        desktop->press("w");
        std::this_thread::sleep_for(1s);
        desktop->release("w");
    });
    EXPECT_GT(moved, 3);
    const double turned = change([] {
        desktop->press("Right");
        std::this_thread::sleep_for(500ms);
        desktop->release("Right");
    });
    EXPECT_GT(turned, 3);
    const double dragged = change([] { desktop->drag(window, {700, 300}, {600, 300}, 3); });
    EXPECT_GT(dragged, 3);
    EXPECT_GT(mean_difference(start, scene()), 3);
    // A drag that leaves the window and comes back turns the view back too, if nothing else.
    const Image8 there = scene();
    desktop->move(window, {700, 300});
    desktop->button(3, true);
    for (const int y : {250, 100, -40, 100, 250, 300}) {
        desktop->move(window, {700, y});
        std::this_thread::sleep_for(60ms);
    }
    desktop->button(3, false);
    EXPECT_TRUE(settle());
    EXPECT_LT(mean_difference(there, scene()), 1);
    EXPECT_GT(change([] { desktop->tap("Home"); }), 3);
    EXPECT_LT(change([] { desktop->tap("Home"); }), 0.01); // there already, but for rounding
}

TEST_F(Viewed, a_key_that_is_only_tapped_moves_too)
{
    EXPECT_GT(change([] { desktop->tap("s"); }), 0.05);
}

TEST_F(Viewed, writes_what_frames_cost)
{
    const auto click = [](ivec2 at) {
        desktop->click(window, at);
        EXPECT_TRUE(settle());
    };
    click({60, 517}); // puts the screenshots' message away
    click(tabs::costs);
    picture("window-costs");
    click({65, 345});  // save as JSON
    click({165, 345}); // save as trace
    for (const char* name : {"atrium.0000.costs.json", "atrium.0000.trace.json"}) {
        EXPECT_NE(bytes_of(folder / name).find("gbuffer"), std::string::npos) << name;
    }
}

TEST_F(Viewed, z_ends_cleanly_and_comes_back_where_it_was)
{
    desktop->tap("F1"); // with the panels go the handles of what was selected, which is not kept
    ASSERT_TRUE(settle());
    const Image8 before = scene();
    desktop->close(window);
    ASSERT_EQ(program->wait(20s), std::optional(0)); // 5: validation had something to say
    EXPECT_NE(bytes_of(folder / "atrium" / "window.toml").find("name = \"b\""), std::string::npos); // the bookmark
    start({"--set", "ao.method=gtao", "--set", "view.vsync=off"});
    desktop->tap("F1");
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(before, scene()), 0);
    desktop->close(window);
    EXPECT_EQ(program->wait(20s), std::optional(0));
}

} // namespace
} // namespace atrium::window
