#pragma once
// A program in a window of a desktop of its own, for tests that look at it and press its keys.

#include "tests/window/desktop.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <utility>

namespace atrium::window {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

inline constexpr ivec2 window_size{900, 560};
inline constexpr int panel = 380; ///< pixels at the left that panels may cover

/// The part of the window that the scene alone fills.
inline Image8 scene_part(const Image8& whole)
{
    Image8 out(std::max(whole.width - panel, 1), whole.height, 3);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            std::copy_n(whole.at(std::min(x + panel, whole.width - 1), y), 3, out.at(x, y));
    return out;
}

inline std::string bytes_of(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// One program in one window for all of a suite's tests: it takes a while to start.
class ViewedProgram : public ::testing::Test {
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
    }
    /// The courtyard's camera and a window of window_size.
    static std::vector<std::string> hero()
    {
        const std::string size = std::to_string(window_size.x) + "x" + std::to_string(window_size.y);
        return {"--camera", "hero", "--size", size, "--set", "ao.method=gtao"};
    }
    /// Runs the program on the courtyard, under validation, and waits for its picture. What it says goes to log().
    static void start(const std::vector<std::string>& options)
    {
        std::vector<std::string> all{(folder / "courtyard" / "courtyard.toml").string(), "--validate"};
        all.insert(all.end(), options.begin(), options.end());
        view(all);
    }
    /// The same on any scene: `arguments` of `atrium view`.
    static void view(const std::vector<std::string>& arguments)
    {
        std::vector<std::string> command{"sh",  "-c", "exec \"$@\" 2>> log", "sh", std::string(ATRIUM_BIN) + "/atrium",
                                         "view"};
        command.insert(command.end(), arguments.begin(), arguments.end());
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
        delete std::exchange(program, nullptr);
        delete std::exchange(desktop, nullptr);
        if (HasFailure()) std::fprintf(stderr, "%s", log().c_str());
        fs::remove_all(folder);
    }
    void SetUp() override
    {
        ASSERT_TRUE(program && program->running()) << "the program has ended";
        desktop->focus(window); // which a window manager may take a while to give back after full screen
        std::this_thread::sleep_for(200ms);
    }

    /// Until the window shows the same three times in a row while the program rests: on a busy machine it may only not
    /// have come to drawing yet.
    static bool settle(std::chrono::seconds most = 20s)
    {
        const auto end = std::chrono::steady_clock::now() + most;
        constexpr double resting = 0.03; // s of the processor between two looks, which it counts in 0.01 s
        Image8 before;
        double used_before = program->cpu_seconds();
        int same = 0;
        while (std::chrono::steady_clock::now() < end) {
            std::this_thread::sleep_for(200ms);
            Image8 now = desktop->grab(window);
            const double used = program->cpu_seconds();
            const bool rests = used - used_before < resting;
            same = rests && now.width > 0 && mean_difference(before, now) == 0 ? same + 1 : 0;
            if (same == 2) return true;
            before = std::move(now);
            used_before = used;
        }
        return false;
    }
    /// Small letters, digits, dots, slashes and underscores.
    static void type(const std::string& text)
    {
        for (const char c : text) {
            if (c == '_')
                desktop->tap("minus", "Shift_L");
            else
                desktop->tap(c == '.' ? "period" : c == '/' ? "slash" : std::string(1, c));
        }
    }
    /// Until the window shows that again.
    static bool comes_back_to(const Image8& before, std::chrono::seconds most = 20s)
    {
        const auto end = std::chrono::steady_clock::now() + most;
        while (mean_difference(before, desktop->grab(window)) > 0) {
            if (std::chrono::steady_clock::now() > end) return false;
            std::this_thread::sleep_for(250ms);
        }
        return true;
    }
    static std::string log() { return bytes_of(folder / "log"); }
    /// Until the program has said the text so many times.
    static bool says(const std::string& text, int times = 1, std::chrono::seconds most = 30s)
    {
        const auto end = std::chrono::steady_clock::now() + most;
        while (std::chrono::steady_clock::now() < end) {
            int seen = 0;
            const std::string all = log();
            for (std::size_t at = all.find(text); at != std::string::npos; at = all.find(text, at + 1)) ++seen;
            if (seen >= times) return true;
            std::this_thread::sleep_for(100ms);
        }
        return false;
    }
    /// Whether a screenshot that is wished for appears, and `render` makes the same bytes of what it says.
    static bool is_drawn_again(const fs::path& shot)
    {
        for (int i = 0; i < 100 && !fs::exists(shot); ++i) std::this_thread::sleep_for(100ms); // it appears whole
        const fs::path again = folder / ("again" + shot.extension().string());
        const std::string command = std::string(ATRIUM_BIN) + "/atrium render " +
                                    (folder / "courtyard" / "courtyard.toml").string() + " --config " + shot.string() +
                                    " -o " + again.string() + " --quiet";
        return std::system(command.c_str()) == 0 && bytes_of(shot) == bytes_of(again);
    }
    /// For scripts/pictures: what the window shows now is a picture in the documents.
    static void picture(const std::string& name)
    {
        if (const char* wanted = std::getenv("ATRIUM_WINDOW_PICTURES"))
            write_png(fs::path(wanted) / (name + ".png"), desktop->grab(window));
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

} // namespace atrium::window
