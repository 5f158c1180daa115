// Shaders that are edited while the window is open.

#include "tests/window/viewed.hpp"

#include <algorithm>

namespace atrium::window {
namespace {

class EditedShaders : public ViewedProgram {
protected:
    static void SetUpTestSuite()
    {
        ViewedProgram::SetUpTestSuite();
        const fs::path sources = fs::path(ATRIUM_SOURCE) / "shaders", copy = folder / "shaders";
        fs::copy(sources, copy, fs::copy_options::recursive);
        // As old as they are there: what is newer than the program is compiled at once.
        for (const auto& file : fs::recursive_directory_iterator(sources))
            fs::last_write_time(copy / fs::relative(file, sources), fs::last_write_time(file));
        std::vector<std::string> options = hero();
        options.insert(options.end(), {"--shaders", copy.string()});
        start(options);
    }
    static std::string read(const std::string& shader) { return bytes_of(folder / "shaders" / shader); }
    static void write(const std::string& shader, const std::string& text)
    {
        std::ofstream(folder / "shaders" / shader) << text;
    }
    /// The shader with a line before its main().
    static std::string with_line(const std::string& text, const std::string& line)
    {
        std::string out = text;
        return out.insert(out.find("void main()"), line + "\n");
    }
};

TEST_F(EditedShaders, broken_ones_are_told_of_and_mended_ones_are_seen)
{
    const std::string tonemap = "techniques/tonemap/tonemap.frag", good = read(tonemap);
    const Image8 start = scene();
    write(tonemap, with_line(good, "int broken = nothing;"));
    const auto line = 1 + std::count(good.begin(), good.begin() + good.find("void main()"), '\n');
    EXPECT_TRUE(says(tonemap + ":" + std::to_string(line) + "\n  why:   'nothing' : undeclared identifier"));
    ASSERT_TRUE(settle());
    EXPECT_GT(mean_difference(start, scene()), 0.02); // the note stands over it
    picture("window-shaders");

    std::string dark = good;
    dark.insert(dark.rfind('}'), "\n    out_color.rgb *= 0.5;\n");
    write(tonemap, dark);
    EXPECT_TRUE(says("all shaders compile again"));
    ASSERT_TRUE(settle());
    EXPECT_GT(mean_difference(start, scene()), 5);
    write(tonemap, good);
    EXPECT_TRUE(says("1 shader(s) compiled, 1 exchanged", 2));
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(start, scene()), 0);
}

TEST_F(EditedShaders, includes_count)
{
    const std::string sky = "lib/sky.glsl", good = read(sky);
    write(sky, good + "\n#error stop here\n");
    EXPECT_TRUE(says("lib/sky.glsl:" + std::to_string(std::count(good.begin(), good.end(), '\n') + 2)));
    write(sky, good);
    EXPECT_TRUE(says("all shaders compile again", 2));
    EXPECT_TRUE(settle());
}

TEST_F(EditedShaders, what_no_longer_fits_the_program_is_refused)
{
    const std::string tonemap = "techniques/tonemap/tonemap.frag", good = read(tonemap);
    const Image8 start = scene();
    write(tonemap, with_line(good, "layout(PASS_IMAGE(9)) uniform texture2D more;"));
    EXPECT_TRUE(says("set 2, binding 9 is new"));
    write(tonemap, good);
    EXPECT_TRUE(says("all shaders compile again", 3));
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(start, scene()), 0);
}

TEST_F(EditedShaders, f5_changes_nothing_where_nothing_has_changed)
{
    const Image8 start = desktop->grab(window);
    desktop->tap("F5");
    EXPECT_TRUE(says(" shader(s) compiled, 0 exchanged", 5)); // four of the tests before
    ASSERT_TRUE(settle());
    EXPECT_EQ(mean_difference(start, desktop->grab(window)), 0);
    desktop->close(window);
    EXPECT_EQ(program->wait(20s), std::optional(0)); // 5: validation had something to say
}

} // namespace
} // namespace atrium::window
