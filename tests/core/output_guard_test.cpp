#include "renderer/core/output_guard.hpp"

#include "expect_error.hpp"
#include "renderer/core/atomic_file.hpp"
#include "temp_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace atrium {
namespace {

namespace fs = std::filesystem;
using test::expect_error;
using test::TempFolder;

TEST(output_guard, one_file_under_many_names)
{
    const TempFolder folder;
    write_text_file(folder / "a.obj", "v 0 0 0\n");
    write_text_file(folder / "b.obj", "v 0 0 0\n"); // the same bytes are not the same file
    fs::create_directory(folder / "sub");
    fs::create_symlink(folder / "a.obj", folder / "soft");
    fs::create_hard_link(folder / "a.obj", folder / "hard");
    fs::create_directory_symlink(folder / "sub", folder / "link");
    for (const char* name : {"a.obj", "soft", "hard", "sub/../a.obj", "./a.obj", "link/../a.obj"})
        EXPECT_TRUE(is_same_file(folder / "a.obj", folder / name)) << name;
    for (const char* name : {"b.obj", "missing.obj", "sub"})
        EXPECT_FALSE(is_same_file(folder / "a.obj", folder / name)) << name;
    EXPECT_TRUE(is_same_file(fs::relative(folder / "a.obj"), folder / "a.obj"));
}

TEST(output_guard, files_that_are_not_there_yet_are_compared_by_their_paths)
{
    const TempFolder folder;
    fs::create_directory(folder / "sub");
    fs::create_directory_symlink(folder / "sub", folder / "link");
    EXPECT_TRUE(is_same_file(folder / "sub/new", folder / "link/new"));
    EXPECT_TRUE(is_same_file(folder / "new", folder / "sub/../new"));
    EXPECT_FALSE(is_same_file(folder / "new", folder / "other"));
    EXPECT_FALSE(is_same_file("", ""));
}

TEST(output_guard, names_the_option_and_the_input)
{
    const TempFolder folder;
    write_text_file(folder / "a.obj", "v 0 0 0\n");
    fs::create_symlink(folder / "a.obj", folder / "out");
    const std::array outputs{OutputFile{"-o", folder / "new"}, OutputFile{"--json", folder / "out"}};
    const std::vector<fs::path> inputs{folder / "b.mtl", folder / "a.obj"};
    expect_error([&] { refuse_overwriting(outputs, inputs); }, ExitCode::usage, (folder / "out").string(), "--json",
                 "a.obj", "another name");
    EXPECT_NO_THROW(refuse_overwriting(std::array{OutputFile{"-o", "-"}, OutputFile{"--json", ""}}, inputs));
    EXPECT_NO_THROW(refuse_overwriting(outputs, {}));
}

} // namespace
} // namespace atrium
