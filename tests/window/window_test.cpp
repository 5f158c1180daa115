// The window on a real X server, moved by real keys and clicks.

#include "tests/window/desktop.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

namespace atrium::window {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr ivec2 window_size{900, 560};
constexpr int panel = 380; ///< pixels at the left that panels may cover

/// The part of the window that the scene alone fills.
Image8 scene_part(const Image8& whole)
{
    Image8 out(std::max(whole.width - panel, 1), whole.height, 3);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            std::copy_n(whole.at(std::min(x + panel, whole.width - 1), y), 3, out.at(x, y));
    return out;
}

/// One program in one window for all of the tests: it takes a while to start.
class Viewed : public ::testing::Test {
protected:
    static void SetUpTestSuite()
    {
        folder = fs::temp_directory_path() / ("atrium-window-" + std::to_string(getpid()));
        fs::create_directories(folder);
        const std::string bin = ATRIUM_BIN, court = (folder / "courtyard").string();
        ASSERT_EQ(std::system((bin + "/assetconv courtyard --detail low " + court + " --quiet").c_str()), 0);
        ASSERT_EQ(
            std::system((bin + "/assetconv bake " + court + "/courtyard.obj -o " + court + "/courtyard.atrium --quiet")
                            .c_str()),
            0);
        desktop = new Desktop({1280, 900});
        const std::string size = std::to_string(window_size.x) + "x" + std::to_string(window_size.y);
        start({"--camera", "hero", "--size", size, "--set", "ao.method=gtao"});
    }
    /// Runs the program on the courtyard with further options and waits for its picture.
    static void start(const std::vector<std::string>& options)
    {
        std::vector<std::string> command{std::string(ATRIUM_BIN) + "/atrium", "view",
                                         (folder / "courtyard" / "courtyard.toml").string(), "--validate"};
        command.insert(command.end(), options.begin(), options.end());
        delete program;
        program = new Process(
            command, folder,
            {"DISPLAY=" + desktop->name(), "XDG_CONFIG_HOME=" + folder.string(), "XDG_CACHE_HOME=" + folder.string()});
        window = desktop->find("Atrium", 60s);
        ASSERT_NE(window, 0u);
        desktop->focus(window);
        ASSERT_TRUE(settle(60s));
    }
    static void TearDownTestSuite()
    {
        delete program;
        delete desktop;
        fs::remove_all(folder);
    }
    void SetUp() override
    {
        ASSERT_TRUE(program && program->running()) << "the program has ended";
        desktop->focus(window); // which a window manager may take a while to give back after full screen
        std::this_thread::sleep_for(200ms);
    }

    /// Until the window shows the same three times in a row.
    static bool settle(std::chrono::seconds most = 20s)
    {
        const auto end = std::chrono::steady_clock::now() + most;
        Image8 before;
        int same = 0;
        while (std::chrono::steady_clock::now() < end) {
            std::this_thread::sleep_for(250ms);
            Image8 now = desktop->grab(window);
            same = now.width > 0 && mean_difference(before, now) == 0 ? same + 1 : 0;
            if (same == 2) return true;
            before = std::move(now);
        }
        return false;
    }
    static Image8 scene() { return scene_part(desktop->grab(window)); }
    /// Does something and tells by how much the scene's picture has changed when all is quiet again.
    template <class F>
    static double change(F&& act)
    {
        const Image8 before = scene();
        act();
        EXPECT_TRUE(settle());
        return mean_difference(before, scene());
    }

    static inline fs::path folder;
    static inline Desktop* desktop = nullptr;
    static inline Process* program = nullptr;
    static inline Desktop::WindowId window = 0;
};

TEST_F(Viewed, shows_what_render_draws)
{
    const fs::path file = folder / "headless.png";
    const std::string command = std::string(ATRIUM_BIN) + "/atrium render " +
                                (folder / "courtyard" / "courtyard.toml").string() + " --camera hero --size " +
                                std::to_string(window_size.x) + "x" + std::to_string(window_size.y) +
                                " --set ao.method=gtao -o " + file.string() + " --quiet";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_LE(mean_difference(scene(), scene_part(read_png(file))), 0.01); // encoded, decoded and encoded again
    // scripts/pictures takes the document's picture of the window here.
    if (const char* wanted = std::getenv("ATRIUM_WINDOW_PICTURE")) write_png(wanted, desktop->grab(window));
}

TEST_F(Viewed, keys_change_techniques_and_undo_takes_it_back)
{
    for (const char* key : {"p", "o", "n"}) {
        const Image8 start = scene();
        EXPECT_GT(change([&] { desktop->tap(key); }), 0.02) << key;
        EXPECT_GT(change([] { desktop->tap("z", "Control_L"); }), 0.02) << key;
        EXPECT_EQ(mean_difference(start, scene()), 0) << key;
    }
}

TEST_F(Viewed, the_selected_light_follows_ctrl_and_drag)
{
    desktop->click(window, {115, 140}); // the tab of lights
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

// scripts/pictures takes the document's picture of buffers here.
TEST_F(Viewed, buffers_take_the_place_of_the_picture_and_stand_beside_it)
{
    const Image8 start = scene();
    EXPECT_GT(change([] { desktop->tap("period"); }), 3); // depth
    EXPECT_GT(change([] { desktop->tap("comma"); }), 3);
    EXPECT_EQ(mean_difference(start, scene()), 0);

    desktop->click(window, {165, 140});
    ASSERT_TRUE(settle());
    const Image8 whole = scene();
    EXPECT_GT(change([] { desktop->click(window, {35, 230}); }), 1);    // pins depth
    EXPECT_GT(change([] { desktop->click(window, {35, 290}); }), 1);    // and the normal
    EXPECT_GT(change([] { desktop->click(window, {470, 430}); }), 3);   // enlarges it
    EXPECT_GT(change([] { desktop->move(window, {600, 250}); }), 0.01); // the value under the mouse
    if (const char* wanted = std::getenv("ATRIUM_WINDOW_PICTURE")) write_png(wanted, desktop->grab(window));
    const double before = program->cpu_seconds();
    std::this_thread::sleep_for(2s);
    EXPECT_LT((program->cpu_seconds() - before) / 2, 0.05); // rests with buffers too
    EXPECT_GT(change([] { desktop->tap("comma"); }), 3);    // before depth is the picture
    EXPECT_GT(change([] { desktop->click(window, {35, 290}); }), 1);
    EXPECT_GT(change([] { desktop->click(window, {35, 230}); }), 1);
    EXPECT_EQ(mean_difference(whole, scene()), 0);
}

TEST_F(Viewed, a_screenshot_is_drawn_again_to_the_byte)
{
    const fs::path shot = folder / "atrium.0000.png", again = folder / "again.png";
    desktop->tap("F12");
    for (int i = 0; i < 100 && !fs::exists(shot); ++i) std::this_thread::sleep_for(100ms);
    ASSERT_TRUE(fs::exists(shot)); // which appears whole
    const std::string command = std::string(ATRIUM_BIN) + "/atrium render " +
                                (folder / "courtyard" / "courtyard.toml").string() + " --config " + shot.string() +
                                " -o " + again.string() + " --quiet";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const auto bytes = [](const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return std::string((std::istreambuf_iterator<char>(in)), {});
    };
    EXPECT_TRUE(bytes(shot) == bytes(again));
    ASSERT_TRUE(settle());
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
    desktop->restore(window);
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(before, desktop->grab(window)), 0);

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
}

TEST_F(Viewed, z_ends_cleanly_and_comes_back_where_it_was)
{
    ASSERT_TRUE(settle());
    const Image8 before = scene();
    desktop->close(window);
    ASSERT_EQ(program->wait(20s), std::optional(0)); // 5: validation had something to say
    start({"--set", "ao.method=gtao"});
    EXPECT_EQ(mean_difference(before, scene()), 0);
    desktop->close(window);
    EXPECT_EQ(program->wait(20s), std::optional(0));
}

} // namespace
} // namespace atrium::window
