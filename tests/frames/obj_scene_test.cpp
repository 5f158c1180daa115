// OBJ files given to `atrium`: the cache of bakes, warnings, and outputs that would replace an input.

#include "program_rig.hpp"

#include "renderer/core/image.hpp"
#include "tests/core/temp_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace atrium {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::text_of;

/// A small scene with its MTL and texture in other folders, and its own cache.
struct ObjScene : ::testing::Test {
    ObjScene()
    {
        for (const char* name : {"model", "library", "pictures"}) fs::create_directory(folder / name);
        write("model/a.obj", "mtllib ../library/a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl m\n"
                             "f 1/1 2/2 3/3\n");
        write("library/a.mtl", "newmtl m\nKd 1 0 0\nmap_Kd ../pictures/t.png\n");
        write_texture(10);
    }
    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    void write_texture(std::uint8_t red) const
    {
        Image8 image(4, 4, 3);
        std::fill(image.values.begin(), image.values.end(), red);
        write_png(folder / "pictures/t.png", image);
    }
    [[nodiscard]] Outcome run(std::vector<std::string> arguments, const std::string& environment = "") const
    {
        return test::atrium(arguments, environment + " XDG_CACHE_HOME=" + test::quoted((folder / "cache").string()));
    }
    /// Bakes the scene or finds it in the cache, and stops before a device is created.
    [[nodiscard]] Outcome open(const std::string& obj = "model/a.obj", const std::string& environment = "") const
    {
        const Outcome outcome = run({"render", (folder / obj).string(), "-o", (folder / "out.png").string(), "--camera",
                                     "none", "--bake-scale", "2"},
                                    environment);
        EXPECT_EQ(outcome.code, 2) << outcome.output;
        EXPECT_NE(outcome.output.find("no camera is called"), std::string::npos) << outcome.output;
        return outcome;
    }
    [[nodiscard]] static bool baked(const Outcome& outcome)
    {
        return outcome.output.find("baking ") != std::string::npos;
    }
    [[nodiscard]] std::vector<fs::path> cached(const std::string& extension) const
    {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder / "cache/atrium/bakes")) {
            if (entry.path().extension() == extension) files.push_back(entry.path());
        }
        return files;
    }
    test::TempFolder folder;
};
using obj_scene = ObjScene;

TEST_F(obj_scene, is_baked_again_when_a_file_that_was_read_changes_and_only_then)
{
    EXPECT_TRUE(baked(open()));
    EXPECT_FALSE(baked(open()));
    write("model/out.png", "an output next to the OBJ");
    write("library/unused.mtl", "newmtl n\n");
    fs::last_write_time(folder / "model/a.obj", fs::file_time_type::clock::now());
    EXPECT_FALSE(baked(open()));
    write("library/a.mtl", "newmtl m\nKd 0 1 0\nmap_Kd ../pictures/t.png\n"); // of the same size
    EXPECT_TRUE(baked(open()));
    write_texture(20);
    const Outcome changed = open();
    EXPECT_TRUE(baked(changed));
    EXPECT_NE(changed.output.find("t.png has changed, so the OBJ is baked again"), std::string::npos) << changed.output;
    EXPECT_FALSE(baked(open()));
    EXPECT_EQ(cached(".atrium").size(), 1u) << "the new bake takes the place of the old one";
}

TEST_F(obj_scene, is_baked_again_when_a_missing_file_comes)
{
    fs::rename(folder / "pictures/t.png", folder / "pictures/later.png");
    EXPECT_TRUE(baked(open()));
    EXPECT_FALSE(baked(open()));
    fs::rename(folder / "pictures/later.png", folder / "pictures/T.png"); // case does not count
    EXPECT_TRUE(baked(open()));
    EXPECT_FALSE(baked(open()));
}

TEST_F(obj_scene, warnings_are_repeated_from_the_cache_and_not_silenced)
{
    fs::remove(folder / "pictures/t.png");
    const std::string warning = "warning: 1 x texture-missing: ";
    const Outcome first = open(), second = open();
    EXPECT_TRUE(baked(first) && !baked(second));
    EXPECT_NE(first.output.find(warning), std::string::npos) << first.output;
    EXPECT_NE(second.output.find(warning), std::string::npos) << second.output;
    for (int i = 0; i < 2; ++i) { // of another scale: baked, then found
        const Outcome quiet = run({"render", (folder / "model/a.obj").string(), "-o", (folder / "out.png").string(),
                                   "--camera", "none", "--bake-scale", "3", "--quiet"});
        EXPECT_EQ(quiet.output.find(warning), 0u) << "nothing is printed before it\n" << quiet.output;
        EXPECT_EQ(quiet.output.find("baking"), std::string::npos) << quiet.output;
        EXPECT_EQ(quiet.output.find("triangles"), std::string::npos) << quiet.output;
    }
}

TEST_F(obj_scene, opened_through_links_finds_its_files)
{
    fs::create_directory(folder / "links");
    fs::create_symlink("../model/a.obj", folder / "links/b.obj");
    EXPECT_EQ(open("links/b.obj").output.find("warning"), std::string::npos);
    EXPECT_FALSE(baked(open("links/b.obj")));
    write("library/a.mtl", "newmtl m\nKd 0 1 0\nmap_Kd ../pictures/t.png\n");
    EXPECT_TRUE(baked(open("links/b.obj")));
    fs::create_directory(folder / "other");
    fs::copy(folder / "model/a.obj", folder / "other/a.obj");
    fs::remove(folder / "links/b.obj");
    fs::create_symlink("../other/a.obj", folder / "links/b.obj"); // the same bytes; that is all that counts
    EXPECT_FALSE(baked(open("links/b.obj")));
}

TEST_F(obj_scene, a_damaged_bake_in_the_cache_is_made_again)
{
    const auto expect_healed = [&](const char* what) {
        const Outcome healed = open();
        EXPECT_TRUE(baked(healed)) << what;
        EXPECT_NE(healed.output.find("in the cache is damaged"), std::string::npos) << what << "\n" << healed.output;
        EXPECT_FALSE(baked(open())) << what;
    };
    static_cast<void>(open());
    const fs::path bake = cached(".atrium").at(0), record = cached(".json").at(0);
    const std::string whole = text_of(bake);
    for (const std::size_t size : {std::size_t{0}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
        fs::resize_file(bake, size);
        expect_healed("truncated");
        EXPECT_EQ(text_of(bake), whole);
    }
    for (const std::size_t at : {std::size_t{9}, std::size_t{50}, std::size_t{4200}, whole.size() - 3}) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ 4);
        std::ofstream(bake, std::ios::binary) << flipped;
        expect_healed("flipped");
        EXPECT_EQ(text_of(bake), whole);
    }
    fs::resize_file(record, fs::file_size(record) / 2);
    expect_healed("a record cut off");
    fs::remove(bake);
    EXPECT_TRUE(baked(open()));
    fs::remove(record);
    EXPECT_TRUE(baked(open()));
}

TEST_F(obj_scene, the_cache_keeps_what_was_used_last_within_its_bound)
{
    for (const char* name : {"b", "c"})
        fs::copy(folder / "model/a.obj", folder / ("model/" + std::string(name) + ".obj"));
    EXPECT_TRUE(baked(open("model/a.obj")));
    EXPECT_TRUE(baked(open("model/b.obj")));
    EXPECT_FALSE(baked(open("model/a.obj")));                                        // now b is the oldest
    for (const fs::path& file : cached(".atrium")) fs::resize_file(file, 600 << 10); // one of them and c fit into 1 MiB
    EXPECT_TRUE(baked(open("model/c.obj", "ATRIUM_CACHE_MIB=1")));
    std::vector<fs::path> left = cached(".atrium");
    EXPECT_EQ(left.size(), 2u);
    for (const fs::path& file : left) EXPECT_NE(file.filename().string()[0], 'b') << file;
    EXPECT_TRUE(baked(open("model/b.obj", "ATRIUM_CACHE_MIB=0"))) << "the bake itself always stays";
    EXPECT_EQ(cached(".atrium").size(), 1u);
    EXPECT_EQ(run({"render", (folder / "model/a.obj").string(), "-o", "x.png"}, "ATRIUM_CACHE_MIB=much").code, 2);
}

TEST_F(obj_scene, no_output_takes_the_place_of_an_input)
{
    ASSERT_TRUE(baked(open()));
    const fs::path bake = folder / "a.atrium", cache = cached(".atrium").at(0);
    fs::copy(cache, bake);
    write("scene.toml", "bake = \"a.atrium\"\n[[instance]]\nbake = \"other.atrium\"\n");
    fs::copy(cache, folder / "other.atrium");
    fs::create_symlink("../library/a.mtl", folder / "model/link.json");
    fs::create_hard_link(folder / "pictures/t.png", folder / "hard.0001.png");
    const auto path = [&](const char* name) { return (folder / name).string(); };
    const std::string obj = path("model/a.obj"), toml = path("scene.toml"), out = path("out.png");
    const std::vector<std::vector<std::string>> cases{
        {"render", obj, "-o", path("pictures/t.png")},
        {"render", obj, "-o", path("pictures/../pictures/t.png")},
        {"render", obj, "-o", path("hard.####.png"), "--frames", "3"},
        {"render", obj, "-o", out, "--stats", obj},
        {"render", obj, "-o", out, "--stats", path("model/link.json")},
        {"render", obj, "-o", out, "--graph", path("library/a.mtl")},
        {"render", obj, "-o", out, "--graph", cache.string(), "--bake-scale", "2"},
        {"render", toml, "-o", out, "--stats", toml},
        {"render", toml, "-o", out, "--stats", bake.string()},
        {"render", toml, "-o", out, "--graph", path("other.atrium")},
        {"render", bake.string(), "-o", out, "--stats", bake.string()},
        {"bench", bake.string(), "--json", bake.string()},
        {"bench", bake.string(), "--source", obj, "--json", obj},
        {"bench", obj, "--json", path("library/a.mtl")},
    };
    const std::vector<std::string> inputs{"model/a.obj", "library/a.mtl", "pictures/t.png",
                                          "a.atrium",    "other.atrium",  "scene.toml"};
    std::vector<std::string> before;
    for (const std::string& input : inputs) before.push_back(text_of(folder / input));
    for (const std::vector<std::string>& arguments : cases) {
        const Outcome refused = run(arguments);
        EXPECT_EQ(refused.code, 2) << fmt::format("{}", fmt::join(arguments, " ")) << "\n" << refused.output;
        EXPECT_NE(refused.output.find("would replace an input"), std::string::npos) << refused.output;
        EXPECT_FALSE(fs::exists(out));
        for (std::size_t i = 0; i < inputs.size(); ++i) EXPECT_EQ(text_of(folder / inputs[i]), before[i]) << inputs[i];
    }
}

} // namespace
} // namespace atrium
