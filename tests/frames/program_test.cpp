// The programs as users call them: exit codes, files and messages.

#include "program_rig.hpp"

#include "renderer/core/image.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>

namespace atrium {
namespace {

using test::atrium;
using test::Outcome;
using test::text_of;

std::filesystem::path in_folder(const std::string& name)
{
    return rig::temporary_folder() / name;
}
std::string court()
{
    return rig::courtyard_bake().string();
}

/// A box of 2 m, closed, or with its inside out: a room.
std::string box_file(bool room)
{
    const std::filesystem::path file = in_folder(room ? "room.atrium" : "box.atrium");
    truth::SceneBuilder builder;
    truth::Shape box = truth::box({-1, 0, -1}, {1, 2, 1});
    if (room) std::reverse(box.triangles.begin(), box.triangles.end());
    builder.add_mesh("box", builder.add_material("grey"), box);
    write_bake(file, builder.finish());
    return file.string();
}

/// The picture's pixels; `said` gets what the program said.
std::vector<std::uint8_t> pixels_of(std::vector<std::string> arguments, std::string* said = nullptr)
{
    const std::string png = in_folder("pixels.png").string();
    arguments.insert(arguments.begin(), "render");
    for (const char* word : {"-o", png.c_str(), "--size", "64x36"}) arguments.emplace_back(word);
    const Outcome outcome = atrium(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    if (said) *said = outcome.output;
    return read_png(png).values;
}

TEST(program, a_floor_lies_below_a_scene_that_came_without_camera_and_light)
{
    const std::string box = box_file(false);
    const auto plain = pixels_of({box}), on = pixels_of({box, "--set", "sky.floor=on"}),
               off = pixels_of({box, "--set", "sky.floor=off"});
    EXPECT_EQ(plain, on);
    EXPECT_NE(plain, off);
    EXPECT_EQ(pixels_of({box, "--set", "sky.floor=auto"}), on);
    // A picture says so of itself.
    ASSERT_EQ(atrium({"render", box, "-o", in_folder("floor.png").string(), "--size", "64x36"}).code, 0);
    EXPECT_EQ(pixels_of({box, "--config", in_folder("floor.png").string()}), on);
    const std::vector<std::vector<std::string>> given = {
        {"--light", "sun"}, {"--no-lights"}, {"--eye", "0,4,6", "--target", "0,1,0"}, {"--from", "inside"}};
    for (const std::vector<std::string>& options : given) {
        std::vector<std::string> as_is{box}, without{box, "--set", "sky.floor=off"};
        as_is.insert(as_is.end(), options.begin(), options.end());
        without.insert(without.end(), options.begin(), options.end());
        EXPECT_EQ(pixels_of(as_is), pixels_of(without)) << options.front();
    }
}

TEST(program, a_camera_inside_a_room_tells_the_way_out)
{
    std::string said;
    const std::string room = box_file(true), box = box_file(false);
    const auto by_itself = pixels_of({room}, &said);
    EXPECT_NE(said.find("--from outside"), std::string::npos) << said;
    EXPECT_EQ(pixels_of({room, "--from", "inside"}, &said), by_itself);
    EXPECT_EQ(said.find("--from"), std::string::npos) << said;
    EXPECT_NE(pixels_of({room, "--from", "outside"}, &said), by_itself);
    EXPECT_EQ(said.find("--from"), std::string::npos) << said;
    const auto outside = pixels_of({box}, &said);
    EXPECT_EQ(said.find("--from"), std::string::npos) << said;
    EXPECT_EQ(pixels_of({box, "--from", "outside"}), outside);
    EXPECT_NE(pixels_of({box, "--from", "inside"}), outside);
    EXPECT_EQ(atrium({"render", box, "-o", in_folder("x.png").string(), "--from", "above"}).code, 2);
}

TEST(program, version_is_quick_and_every_command_has_help)
{
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(atrium({"--version"}).code, 0);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
              0.5); // 0.05 without sanitizers
    for (const char* command : {"render", "bench", "compare", "upscale", "settings", "devices"}) {
        const Outcome help = atrium({command, "--help"});
        EXPECT_EQ(help.code, 0);
        EXPECT_NE(help.output.find("Example"), std::string::npos) << command;
    }
}

/// A picture of vertical stripes, 24 x 16.
std::string stripes(const std::string& name, int contrast)
{
    Image8 image(24, 16, 3, 100);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; x += 2)
            std::fill_n(image.at(x, y), 3, static_cast<std::uint8_t>(100 + contrast));
    }
    const std::filesystem::path file = in_folder(name);
    std::filesystem::create_directories(file.parent_path());
    write_png(file, image);
    return file.string();
}

TEST(program, compares_pairs_and_folders)
{
    const std::string a = stripes("compare-a/1.png", 40), b = stripes("compare-b/1.png", 90);
    static_cast<void>(stripes("compare-a/2.PNG", 40));
    static_cast<void>(stripes("compare-b/2.PNG", 40));
    EXPECT_EQ(atrium({"compare", a, a, "--fail-above", "0"}).code, 0);
    EXPECT_EQ(atrium({"compare", a, b, "--fail-above", "0"}).code, 1);
    EXPECT_EQ(atrium({"compare", a, b, "--metric", "ssim", "--fail-below", "0.999"}).code, 1);
    const std::string heat = in_folder("heat.png").string();
    EXPECT_EQ(atrium({"compare", a, b, "--diff", heat}).code, 0);
    EXPECT_EQ(read_png(heat).width, 24);

    const std::vector<std::string> folders{"compare", in_folder("compare-a").string(), in_folder("compare-b").string()};
    const Outcome both = atrium(folders);
    EXPECT_EQ(both.code, 0);
    for (const char* row : {"1.png", "2.PNG", "mean"})
        EXPECT_NE(both.output.find(row), std::string::npos) << both.output;
    Image8 small(5, 5, 3);
    write_png(in_folder("small.png"), small);
    const Outcome sizes = atrium({"compare", a, in_folder("small.png").string()});
    EXPECT_EQ(sizes.code, 3);
    EXPECT_NE(sizes.output.find("24 x 16"), std::string::npos) << sizes.output;
}

TEST(program, upscales_a_picture)
{
    const std::string small = stripes("stripes.png", 40), large = in_folder("large.png").string();
    for (const char* method : {"fsr1", "bilinear", "catmullrom", "lanczos"}) {
        EXPECT_EQ(atrium({"upscale", small, "-o", large, "--ratio", "1.5", "--method", method, "--validate"}).code, 0);
        const Image8 picture = read_png(large);
        EXPECT_EQ(uvec2(picture.width, picture.height), uvec2(36, 24)) << method;
    }
    EXPECT_EQ(atrium({"upscale", small, "-o", large, "--ratio", "1", "--sharpness", "off"}).code, 0);
    EXPECT_EQ(read_png(large).values, read_png(small).values);
    EXPECT_EQ(atrium({"upscale", small, "-o", large, "--ratio", "5"}).code, 2);
}

TEST(program, wrong_use_ends_with_2_and_names_the_nearest)
{
    const std::string png = in_folder("wrong.png").string();
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{}, "render"},
        {{"frobnicate"}, "unknown command \"frobnicate\""},
        {{"rendr", "x", "--size", "64x36"}, "unknown command \"rendr\""},
        {{"rendr", "x", "--size", "64x36"}, "did you mean \"render\"?"},
        {{"--size", "64x36", "render"}, "--size"},
        {{"render", court(), "-o", png, "--set", "shadow.filter=temporal"}, "off, hard, pcf"},
        {{"render", court(), "-o", png, "--sizee", "64x36"}, "--size"},
        {{"render", court(), "-o", png, "--size", "64"}, "WxH"},
        {{"render", court(), "-o", png, "--set", "tonemap.oprator=aces"}, "tonemap.operator"},
        {{"render", court(), "-o", png, "--set", "tonemap.operator=aecs"}, "aces"},
        {{"render", court(), "-o", png, "--set", "exposure.ev100=x"}, "exposure.ev100"},
        {{"render", court(), "-o", png, "--set", "camera.near=-5"}, "camera.near"},
        {{"render", court(), "-o", png, "--light", "spot,potision=0:1:0"}, "position"},
        {{"render", court(), "-o", png, "--light", "sun,name=a", "--light", "sun,name=a"}, "a"},
        {{"render", court(), "-o", png, "--aov", "dpeth=d.exr"}, "depth"},
        {{"render", court(), "-o", png, "--eye", "0,1,0", "--target", "0,1,0"}, "camera"},
        {{"render", court(), "-o", "picture.jpg"}, ".png"},
        {{"render", court(), "-o", png, "--camera", "nave"}, "camera"},
        {{"render", court(), "-o", png, "--preset", "referense"}, "reference"},
        {{"render", court(), "-o", png, "--frames", "0"}, "--frames"},
        {{"compare", "a.png", "b.png", "--fail-below", "1"}, "--metric"},
        {{"upscale", "a.png", "-o", png}, "--ratio"},
        {{"upscale", "a.png", "-o", png, "--ratio", "2", "--sharpness", "x"}, "--sharpness"},
        {{"upscale", "a.png", "-o", "a.png", "--ratio", "2"}, "a.png"},
    };
    for (const auto& [arguments, word] : cases) {
        const Outcome outcome = atrium(arguments);
        EXPECT_EQ(outcome.code, 2) << outcome.output;
        EXPECT_NE(outcome.output.find(word), std::string::npos) << word << "\n" << outcome.output;
        EXPECT_FALSE(std::filesystem::exists(png));
    }
}

TEST(program, bad_and_missing_files_end_with_3_unwritable_ones_with_4)
{
    const std::string png = in_folder("bad.png").string();
    EXPECT_EQ(atrium({"render", "nowhere.atrium", "-o", png}).code, 3);
    std::ofstream(in_folder("wrong.toml")) << "bake = \"" << court() << "\"\n[camera.door]\neey = [1.0, 2.0, 1.0]\n";
    const Outcome outcome = atrium({"render", in_folder("wrong.toml").string(), "-o", png});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.output.find("wrong.toml:3"), std::string::npos) << outcome.output;
    EXPECT_EQ(atrium({"render", court(), "-o", "no/such/folder/out.png"}).code, 4);
    EXPECT_EQ(atrium({"render", court(), "-o", png, "--device", "no such device"}).code, 2);
}

TEST(program, minus_may_begin_a_value)
{
    const std::string png = in_folder("minus.png").string();
    EXPECT_EQ(atrium({"render", court(), "-o", png, "--size", "32x18", "--eye", "-1,2,1", "--target", "-.5,2,0"}).code,
              0);
}

TEST(program, a_picture_carries_what_draws_it_again)
{
    const std::string first = in_folder("first.png").string(), second = in_folder("second.png").string();
    ASSERT_EQ(atrium({"render", court(), "-o", first, "--size", "64x36", "--eye", "-8,1.7,0.5", "--target", "8,2.5,0",
                      "--light", "point,position=0:3:0,name=lamp", "--set", "exposure.ev100=1.5", "--set",
                      "sky.zenith=0.1:0.2:0.9"})
                  .code,
              0);
    ASSERT_EQ(atrium({"render", court(), "-o", second, "--config", first}).code, 0);
    EXPECT_EQ(text_of(first), text_of(second));
    ImageMetadata metadata;
    static_cast<void>(read_png(first, &metadata));
    const std::string text = metadata.at("atrium");
    EXPECT_NE(text.find("lamp"), std::string::npos);
    EXPECT_EQ(text.find("first.png"), std::string::npos) << "no output name, so that equal pictures are equal files";
}

TEST(program, a_picture_is_drawn_again_from_whatever_it_says)
{
    // Values at the ends of what the program takes, and beyond what a scene file may say.
    const std::vector<std::vector<std::string>> cases{
        {"--eye", "5e6,2e7,-3e6", "--target", "5e6,1.9e7,-0", "--fov", "170"},
        {"--eye", "3.4028235e38,1e-45,-1e-7", "--target", "0,-0,9500000000000000", "--fov", "1"},
        {"--time", "0.1", "--eye", "-8,1.7,0.5", "--target", "8,2.5,0", "--fov", "59.999996"},
        {"--time", "-12345678.000000123", "--no-lights"},
        {"--time", "9007199254740993", "--size", "1x16"},
        {"--time", "1e300", "--set", "camera.near=1e-7", "--set", "exposure.ev100=0.1"},
        {"--light", "sun,direction=1e6:-1e6:1e-3,illuminance=1e9,angle=90,name=\"a\\b #ä\""},
        {"--light", "spot,position=-1e6:1e6:0.1,inner=80,outer=80,intensity=0,size=0.0001,range=1e6,color=0:1e9:1e-9",
         "--light", "rect,position=-0:0:0,up=0:1e-6:0,width=10000,height=0.0001,radiance=1e9,shadow=off"},
        // A CPU device has another default: only a picture that says so gets these again.
        {"--set", "texture.anisotropy=8", "--set", "shadow.samples=32"},
    };
    const std::string first = in_folder("ends.png").string(), second = in_folder("ends2.png").string();
    for (const std::vector<std::string>& options : cases) {
        std::vector<std::string> arguments{"render", court(), "-o", first, "--set", "sky.zenith=0.1:0.2:0.9"};
        if (std::find(options.begin(), options.end(), "--size") == options.end())
            arguments.insert(arguments.end(), {"--size", "16x9"});
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome drawn = atrium(arguments);
        ASSERT_EQ(drawn.code, 0) << options[1] << drawn.output;
        const Outcome again = atrium({"render", court(), "-o", second, "--config", first});
        ASSERT_EQ(again.code, 0) << options[1] << again.output;
        EXPECT_EQ(text_of(first), text_of(second)) << options[1];
    }
    for (const char* option : {"--time", "--fov", "--dt"}) { // no picture could say it
        for (const char* value : {"nan", "inf"})
            EXPECT_EQ(atrium({"render", court(), "-o", first, option, value}).code, 2) << option << " " << value;
    }
}

TEST(program, frames_are_numbered_and_resumed)
{
    const std::string pattern = in_folder("f.##.png").string();
    ASSERT_EQ(atrium({"render", court(), "-o", pattern, "--size", "32x18", "--frames", "2-4"}).code, 0);
    for (const char* name : {"f.02.png", "f.03.png", "f.04.png"})
        EXPECT_TRUE(std::filesystem::exists(in_folder(name))) << name;
    EXPECT_FALSE(std::filesystem::exists(in_folder("f.05.png")));
    const auto before = std::filesystem::last_write_time(in_folder("f.03.png"));
    std::filesystem::remove(in_folder("f.04.png"));
    ASSERT_EQ(atrium({"render", court(), "-o", pattern, "--size", "32x18", "--frames", "2-4", "--resume"}).code, 0);
    EXPECT_TRUE(std::filesystem::exists(in_folder("f.04.png")));
    EXPECT_EQ(std::filesystem::last_write_time(in_folder("f.03.png")), before);
}

/// Frames 0 to 5 of a walk, into numbered files of a folder of their own, with an AOV beside.
struct Walk {
    explicit Walk(const std::string& name) : folder(in_folder(name))
    {
        std::filesystem::create_directories(folder);
        write_scene("[-8.0, 1.7, 0.5]");
    }
    void write_scene(const std::string& first_eye, const std::string& more = "") const
    {
        std::ofstream(folder / "walk.toml") << "bake = \"" << court() << "\"\n[path.walk]\nkeys = [\n"
                                            << "{ time = 0.0, eye = " << first_eye << ", target = [8.0, 2.5, 0.0] },\n"
                                            << "{ time = 1.0, eye = [-4.0, 1.7, 0.5], target = [8.0, 2.5, 3.0] },\n]\n"
                                            << more;
    }
    [[nodiscard]] Outcome render(const std::vector<std::string>& more) const
    {
        std::vector<std::string> arguments{"render",   (folder / "walk.toml").string(),
                                           "--path",   "walk",
                                           "--size",   "48x27",
                                           "--frames", "0-5",
                                           "--dt",     "0.2",
                                           "-o",       (folder / "f.##.png").string(),
                                           "--aov",    "depth=" + (folder / "depth.##.exr").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return atrium(arguments);
    }
    [[nodiscard]] std::vector<std::string> files() const
    {
        std::vector<std::string> out;
        for (int i = 0; i < 6; ++i) {
            out.push_back(text_of(folder / fmt::format("f.{:02}.png", i)));
            out.push_back(text_of(folder / fmt::format("depth.{:02}.exr", i)));
        }
        return out;
    }
    std::filesystem::path folder;
};

TEST(program, resumed_frames_are_those_of_one_run)
{
    const Walk whole("whole"), broken("broken");
    ASSERT_EQ(whole.render({}).code, 0);
    ASSERT_EQ(broken.render({}).code, 0);
    EXPECT_EQ(broken.files(), whole.files());
    std::filesystem::remove(broken.folder / "f.05.png");
    std::filesystem::remove(broken.folder / "depth.04.exr");
    std::filesystem::resize_file(broken.folder / "f.02.png", 700); // as a copy that was cut off
    std::filesystem::copy_file(broken.folder / "f.00.png", broken.folder / "f.01.png",
                               std::filesystem::copy_options::overwrite_existing); // another frame under its name
    const auto kept = std::filesystem::last_write_time(broken.folder / "f.03.png");
    const Outcome outcome = broken.render({"--resume"});
    ASSERT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.output.find("2 of 6 frames are there already"), std::string::npos) << outcome.output;
    EXPECT_EQ(broken.files(), whole.files());
    EXPECT_EQ(std::filesystem::last_write_time(broken.folder / "f.03.png"), kept);
    EXPECT_NE(broken.render({"--resume"}).output.find("6 of 6"), std::string::npos);
}

TEST(program, frames_of_other_settings_paths_and_scenes_are_drawn_again)
{
    const Walk walk("changed");
    ASSERT_EQ(walk.render({}).code, 0);
    const auto redrawn = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = more;
        arguments.emplace_back("--resume");
        const Outcome outcome = walk.render(arguments);
        EXPECT_EQ(outcome.code, 0);
        return outcome.output.find("are there already") == std::string::npos;
    };
    EXPECT_FALSE(redrawn({}));
    EXPECT_TRUE(redrawn({"--set", "exposure.ev100=3"}));
    EXPECT_TRUE(redrawn({"--light", "point,position=0:3:0"}));
    EXPECT_TRUE(redrawn({"--fov", "40"}));
    walk.write_scene("[-8.0, 1.7, 0.5]", "[[material]]\nmatch = \"*\"\nroughness = 0.25\n");
    EXPECT_TRUE(redrawn({}));
    EXPECT_FALSE(redrawn({}));
    walk.write_scene("[-8.5, 1.7, 0.5]", "[[material]]\nmatch = \"*\"\nroughness = 0.25\n");
    EXPECT_TRUE(redrawn({}));
    EXPECT_EQ(atrium({"render", court(), "-o", in_folder("one.png").string(), "--resume"}).code, 2);
}

TEST(program, stats_and_bench_have_their_keys)
{
    const std::string stats_file = in_folder("stats.json").string(), bench_file = in_folder("bench.json").string();
    ASSERT_EQ(
        atrium({"render", court(), "-o", in_folder("s.png").string(), "--size", "64x36", "--stats", stats_file}).code,
        0);
    const auto stats = nlohmann::json::parse(text_of(stats_file));
    for (const char* key : {"device", "size", "frames", "load_ms", "frame_ms", "cpu_ms", "passes", "draws", "triangles",
                            "pipeline_binds", "material_changes", "memory_bytes", "validation_messages"}) {
        EXPECT_TRUE(stats.contains(key)) << key;
    }
    ASSERT_EQ(atrium({"bench", court(), "--size", "64x36", "--floors", "--runs", "2", "--json", bench_file}).code, 0);
    std::vector<std::string> names;
    const auto bench = nlohmann::json::parse(text_of(bench_file));
    for (const auto& row : bench.at("runs")) names.push_back(row.at("name"));
    for (const char* name : {"cull", "gbuffer", "lighting", "sky", "tonemap", "frame", "load", "floor.t16",
                             "floor.gbuffer", "floor.lighting", "floor.copy"}) {
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    }
}

TEST(program, scene_file_places_instances_and_overrides_materials)
{
    std::ofstream(in_folder("scene.toml"))
        << "bake = \"" << court() << "\"\n"
        << "[camera.end]\neye = [-8.0, 1.7, 0.5]\ntarget = [8.0, 2.5, 0.0]\n"
        << "[[light]]\ntype = \"sun\"\nname = \"sun\"\n"
        << "[[instance]]\nbake = \"" << court() << "\"\nposition = [0.0, 20.0, 0.0]\n"
        << "[[material]]\nmatch = \"*\"\nroughness = 0.25\n";
    const std::string aov = in_folder("instance.exr").string(), rough = in_folder("rough.exr").string();
    ASSERT_EQ(atrium({"render", in_folder("scene.toml").string(), "-o", in_folder("scene.png").string(), "--size",
                      "64x36", "--eye", "0,60,0.1", "--target", "0,0,0", "--aov", "instance=" + aov, "--aov",
                      "roughness=" + rough, "--set", "specular_mapping=off"})
                  .code,
              0);
    const ImageF instance = read_exr(aov), roughness = read_exr(rough);
    bool upper = false;
    for (std::size_t i = 0; i < instance.values.size(); ++i) {
        upper = upper || instance.values[i] == 1;
        if (instance.values[i] >= 0) {
            EXPECT_NEAR(roughness.values[i], 0.25f, 0.005f);
        }
    }
    EXPECT_TRUE(upper) << "the second instance stands above the first and is seen from above";
}

TEST(docs, settings_page_is_what_the_program_says)
{
    EXPECT_EQ(text_of(std::filesystem::path(ATRIUM_SOURCE) / "docs" / "settings.md"),
              atrium({"settings", "--markdown"}).output)
        << "make it anew: atrium settings --markdown > docs/settings.md";
}

} // namespace
} // namespace atrium
