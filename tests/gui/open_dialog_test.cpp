// The dialog that asks for a scene, and how it completes what is typed.

#include "app/gui/open_dialog.hpp"
#include "tests/gui/headless.hpp"

#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

namespace atrium::gui {
namespace {

namespace fs = std::filesystem;

class OpenDialogs : public ::testing::Test {
protected:
    void SetUp() override
    {
        fs::create_directories(folder / "court");
        for (const char* file : {"courtyard.OBJ", "courtyard.toml", "notes.txt", ".hidden.obj"})
            std::ofstream(folder / file) << "\n";
        fs::create_symlink("nowhere", folder / "lost.obj");
    }
    void TearDown() override { fs::remove_all(folder); }
    [[nodiscard]] std::string in_folder(const std::string& name) const { return (folder / name).string(); }

    const fs::path folder = fs::temp_directory_path() / ("atrium-open-" + std::to_string(getpid()));
};

TEST_F(OpenDialogs, folders_and_scenes_are_listed)
{
    using Lines = std::vector<std::string>;
    EXPECT_EQ(list_scenes(in_folder("")).lines, (Lines{"court/", "courtyard.OBJ", "courtyard.toml"}));
    EXPECT_EQ(list_scenes(in_folder(".")).lines, Lines{".hidden.obj"});
    EXPECT_EQ(list_scenes(in_folder("courtyard.t")).lines, Lines{"courtyard.toml"});
    EXPECT_EQ(list_scenes(in_folder("x")).lines, Lines{});
    EXPECT_EQ(list_scenes(in_folder("no/such/folder/")).lines, Lines{});
}

TEST_F(OpenDialogs, what_is_typed_is_completed_as_far_as_it_is_clear)
{
    EXPECT_EQ(list_scenes(in_folder("c")).completed, in_folder("court"));
    EXPECT_EQ(list_scenes(in_folder("courty")).completed, in_folder("courtyard."));
    EXPECT_EQ(list_scenes(in_folder("courtyard.t")).completed, in_folder("courtyard.toml"));
    EXPECT_EQ(list_scenes(in_folder("x")).completed, in_folder("x"));
}

TEST_F(OpenDialogs, is_never_cut_off)
{
    const fs::path here = fs::current_path(), deep = folder / std::string(100, 'y') / std::string(100, 'z');
    fs::create_directories(deep);
    fs::current_path(deep); // which is listed
    const std::array<fs::path, 2> recent{"/a/scene.toml", std::string(300, 'x') + ".obj"};
    for (const auto& [width, height] : {std::pair{320.0f, 240.0f}, {800.0f, 600.0f}, {2560.0f, 1440.0f}}) {
        for (const float scale : {1.0f, 1.5f}) {
            const test::HeadlessGui gui(width, height, scale);
            OpenDialog dialog;
            dialog.show();
            for (int i = 0; i < 3; ++i) // sizes itself in the first
                gui.frame([&] { static_cast<void>(dialog.draw(recent, scale)); }, false);
            for (const std::string& window : gui.cut_off()) ADD_FAILURE() << window << " at " << scale;
        }
    }
    fs::current_path(here);
}

TEST_F(OpenDialogs, a_typed_file_is_opened_and_a_folder_is_gone_into)
{
    const test::HeadlessGui gui(1280, 720);
    OpenDialog dialog;
    std::optional<fs::path> chosen;
    const auto frame = [&](bool enter) {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyMap[ImGuiKey_Enter] = 1;
        io.KeysDown[1] = enter;
        gui.frame(
            [&] {
                if (const auto file = dialog.draw({}, 1)) chosen = file;
            },
            false);
    };
    const auto type = [&](const std::string& text) {
        gui.type(text.c_str());
        for (const bool enter : {false, true, false, false}) frame(enter);
    };
    dialog.show();
    for (int i = 0; i < 3; ++i) frame(false);
    type(in_folder("court"));
    EXPECT_FALSE(chosen.has_value());
    type("missing.obj"); // whether it is there is found out when it is opened
    EXPECT_EQ(chosen, folder / "court" / "missing.obj");
}

} // namespace
} // namespace atrium::gui
