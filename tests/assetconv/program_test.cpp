// The program from outside: exit codes, messages, files left behind.

#include "bake_rig.hpp"

#include <sys/wait.h>

#include <csignal>
#include <sstream>

namespace atrium {
namespace {

using test::Folder;

struct Result {
    int code = 0;
    std::string output; ///< both streams
};

Result run(const Folder& folder, const std::string& arguments)
{
    const std::string log = (folder / "log").string();
    const int status = std::system(
        ("cd " + (folder / "").string() + " && " ATRIUM_ASSETCONV " " + arguments + " > " + log + " 2>&1").c_str());
    std::ostringstream text;
    text << std::ifstream(log).rdbuf();
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text.str()};
}

TEST(program, exit_codes)
{
    const Folder folder;
    folder.write("a.obj", test::square + test::square_face);
    EXPECT_EQ(run(folder, "--version").output, "assetconv " ATRIUM_VERSION "\n");
    EXPECT_EQ(run(folder, "").code, 2);
    EXPECT_EQ(run(folder, "bake a.obj --scale -1").code, 2);
    EXPECT_EQ(run(folder, "bake nowhere.obj").code, 3);
    EXPECT_EQ(run(folder, "info a.obj").code, 3);
    EXPECT_EQ(run(folder, "bake a.obj -o gone/a.atrium").code, 4);
    EXPECT_EQ(run(folder, "bake a.obj").code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "a.atrium")); // the current folder, the OBJ's name
    EXPECT_EQ(run(folder, "verify a.atrium").code, 0);
    EXPECT_EQ(run(folder, "info a.atrium --json - > /dev/full; exit $?").code, 4);
}

TEST(program, every_command_helps_with_an_example)
{
    const Folder folder;
    for (const std::string command : {"bake", "info", "verify", "courtyard"}) {
        const Result help = run(folder, command + " --help");
        EXPECT_EQ(help.code, 0);
        EXPECT_NE(help.output.find("Example:\n  assetconv " + command), std::string::npos);
    }
}

TEST(program, mistyped_names_get_the_nearest_one)
{
    const Folder folder;
    EXPECT_NE(run(folder, "bake a.obj --sclae 1").output.find("did you mean --scale?"), std::string::npos);
    EXPECT_NE(run(folder, "verfy x").output.find("did you mean verify?"), std::string::npos);
    EXPECT_NE(run(folder, "bake a.obj --textures bcn").output.find("did you mean bc?"), std::string::npos);
    EXPECT_EQ(run(folder, "frobnicate").code, 2);
}

TEST(program, a_failed_bake_leaves_no_file)
{
    const Folder folder;
    folder.write("a.obj", "mtllib gone.mtl\n" + test::square + test::square_face);
    EXPECT_EQ(run(folder, "bake a.obj --strict -o a.atrium").code, 3);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.atrium"));
    EXPECT_EQ(run(folder, "bake a.obj -o a.atrium --json a.json -q").code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "a.json"));
}

TEST(program, a_stop_signal_ends_it_as_that_signal)
{
    const Folder folder;
    std::string text = test::square;
    for (int i = 0; i < 300000; ++i) text += test::square_face;
    folder.write("long.obj", text);
    const Result stopped = run(folder, "bake long.obj & pid=$!; sleep 0.1; kill -TERM $pid; wait $pid; exit $?");
    EXPECT_EQ(stopped.code, 128 + SIGTERM);
    for (const auto& entry : std::filesystem::directory_iterator(folder / "")) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(name == "long.obj" || name == "log") << name;
    }
}

} // namespace
} // namespace atrium
