// The program from outside: exit codes, messages, files left behind.

#include "bake_rig.hpp"

#include <sys/wait.h>

#include <algorithm>
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
    EXPECT_NE(run(folder, "verfy x").output.find("did you mean \"verify\"?"), std::string::npos);
    EXPECT_NE(run(folder, "bake a.obj --textures bcn").output.find("did you mean \"bc\"?"), std::string::npos);
    const Result unknown = run(folder, "frobnicate --size 64x36");
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.output.find("unknown command \"frobnicate\""), std::string::npos) << unknown.output;
    EXPECT_EQ(unknown.output.find("did you mean"), std::string::npos) << unknown.output;
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

TEST(program, warnings_are_said_also_by_a_quiet_bake)
{
    const Folder folder;
    folder.write("a.obj", "mtllib none.mtl\n" + test::square + "usemtl m\n" + test::square_face + "f 1 2 9\nf 1 2 8\n");
    for (const std::string flag : {"", " -q", " -v"}) {
        const Result baked = run(folder, "bake a.obj" + flag);
        EXPECT_EQ(baked.code, 0);
        const std::string missing = "warning: 1 x mtl-missing: ", dropped = "warning: 2 x face-bad-index: ";
        EXPECT_NE(baked.output.find(missing), std::string::npos) << baked.output;
        EXPECT_NE(baked.output.find("none.mtl"), std::string::npos) << baked.output;
        EXPECT_NE(baked.output.find(dropped), std::string::npos) << baked.output;
        if (flag == " -q") {
            EXPECT_EQ(std::count(baked.output.begin(), baked.output.end(), '\n'), 3) << "one line a kind\n"
                                                                                     << baked.output;
        }
    }
    const Result info = run(folder, "info a.atrium");
    EXPECT_NE(info.output.find("1 x mtl-missing: "), std::string::npos) << info.output;
}

/// Every file of a small scene is as it was written, and no other is there.
struct UntouchedScene {
    UntouchedScene()
    {
        folder.write("a.obj", "mtllib a.mtl\n" + test::square + "usemtl m\n" + test::square_face);
        folder.write("a.mtl", "newmtl m\nmap_Kd tex/t.png\n");
        folder.write_image("tex/t.png", 4, 4, 3, [](int x, int) { return test::Rgb{x * 60, 0, 0}; });
        for (const char* name : {"a.obj", "a.mtl", "tex/t.png"}) before.push_back(text(name));
    }
    [[nodiscard]] std::string text(const std::string& name) const
    {
        std::ostringstream out;
        out << std::ifstream(folder / name, std::ios::binary).rdbuf();
        return out.str();
    }
    void expect_refused(const std::string& arguments) const
    {
        const Result result = run(folder, arguments);
        EXPECT_EQ(result.code, 2) << arguments << "\n" << result.output;
        for (const char* part : {"would replace an input", "where: ", "why: ", "next: "})
            EXPECT_NE(result.output.find(part), std::string::npos) << arguments << "\n" << result.output;
        std::size_t i = 0;
        for (const char* name : {"a.obj", "a.mtl", "tex/t.png"}) EXPECT_EQ(text(name), before[i++]) << arguments;
    }
    Folder folder;
    std::vector<std::string> before;
};

TEST(program, an_output_that_is_an_input_is_refused)
{
    const UntouchedScene scene;
    std::filesystem::create_symlink("a.obj", scene.folder / "soft");
    std::filesystem::create_hard_link(scene.folder / "a.mtl", scene.folder / "hard");
    std::filesystem::create_directory_symlink("tex", scene.folder / "pictures");
    for (const char* output :
         {"a.obj", "./a.obj", "tex/../a.obj", "soft", "a.mtl", "hard", "tex/t.png", "pictures/t.png"}) {
        scene.expect_refused(std::string("bake a.obj -o ") + output);
        scene.expect_refused(std::string("bake a.obj -o x.atrium --json ") + output);
        scene.expect_refused(std::string("bake a.obj -o x.atrium --dependencies ") + output);
    }
    EXPECT_FALSE(std::filesystem::exists(scene.folder / "x.atrium"));
    EXPECT_EQ(run(scene.folder, "bake a.obj -o a.atrium --json a.json").code, 0);
    const std::string bake = scene.text("a.atrium");
    scene.expect_refused("info a.atrium --json a.atrium");
    EXPECT_EQ(scene.text("a.atrium"), bake);
    std::filesystem::copy(scene.folder / "a.obj", scene.folder / "b.atrium"); // the default's name is its own
    scene.expect_refused("bake b.atrium");
    EXPECT_EQ(scene.text("b.atrium"), scene.before[0]);
    EXPECT_EQ(run(scene.folder, "bake a.obj -o a.atrium").code, 0) << "an older bake is no input";
}

TEST(program, an_obj_behind_links_finds_what_stands_beside_each)
{
    const Folder folder;
    folder.write("real/a.obj", "mtllib a.mtl b.mtl\n" + test::square + "usemtl a\n" + test::square_face + "usemtl b\n" +
                                   "f 1/1/1 2/2/1 3/3/1\n");
    folder.write("real/a.mtl", "newmtl a\nKd 1 0 0\nmap_Kd ../pictures/t.png\n");
    folder.write_image("pictures/t.png", 4, 4, 3, [](int x, int) { return test::Rgb{x * 60, 0, 0}; });
    std::filesystem::create_directories(folder / "links/deep");
    folder.write("links/b.mtl", "newmtl b\nKd 0 1 0\n");
    std::filesystem::create_symlink("../real/a.obj", folder / "links/middle.obj");
    std::filesystem::create_symlink("../middle.obj", folder / "links/deep/a.obj");
    const Result baked = run(folder, "bake links/deep/a.obj -o a.atrium -q");
    EXPECT_EQ(baked.code, 0);
    EXPECT_EQ(baked.output, "") << "nothing is missing";
    std::filesystem::create_directory_symlink("../../real", folder / "links/deep/folder"); // real is not deep/..
    EXPECT_EQ(run(folder, "bake links/deep/folder/a.obj -o b.atrium -q").output.find("texture"), std::string::npos);
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
