// The bake as a whole: options, what reaches the file, and that nothing depends on chance.

#include "bake_rig.hpp"

#include "assetconv/info.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/jobs.hpp"

#include <cstring>
#include <sstream>

namespace atrium {
namespace {

using test::Folder;

std::string read_file(const std::filesystem::path& path)
{
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

/// Several groups, materials and textures: enough work to come in different orders.
std::filesystem::path write_scene(const Folder& folder)
{
    std::string obj = "mtllib scene.mtl\n", mtl;
    for (int i = 0; i < 12; ++i) {
        const std::string n = std::to_string(i);
        folder.write_image("c" + n + ".png", 33 + i, 20, 4, [&](int x, int y) {
            return test::Rgba{x * 5, y * 9, i * 20, (x * y) % 3 == 0 ? 0 : 255};
        });
        mtl += "newmtl m" + n + "\nmap_Kd c" + n + ".png\nmap_bump c" + std::to_string((i + 5) % 12) + ".png\n";
        obj += "g g" + n + "\nusemtl m" + n + "\n";
        for (int k = 0; k < 200; ++k) {
            for (int c = 0; c < 3; ++c) {
                obj += "v " + std::to_string(i + 0.01 * k) + " " + std::to_string(std::sin(k * 0.7 + c)) + " " +
                       std::to_string(std::cos(k * 1.3 + 2 * c)) + "\n";
                obj += "vt " + std::to_string(0.1 * k) + " " + std::to_string(0.3 * c * c) + "\n";
            }
            obj += "f -3/-3 -2/-2 -1/-1\n";
        }
    }
    folder.write("scene.mtl", mtl);
    return folder.write("scene.obj", obj);
}

TEST(bake, same_bytes_whatever_the_number_of_threads)
{
    const Folder folder;
    BakeOptions options;
    options.input = write_scene(folder);
    for (const int threads : {1, 2, 5}) {
        set_job_threads(threads);
        write_bake(folder / (std::to_string(threads) + ".atrium"), bake_scene(options));
    }
    set_job_threads(0);
    const std::string one = read_file(folder / "1.atrium");
    EXPECT_EQ(one, read_file(folder / "2.atrium"));
    EXPECT_EQ(one, read_file(folder / "5.atrium"));
    EXPECT_EQ(verify_bake(folder / "1.atrium").size(), 4u);
    const BakeFile back(folder / "1.atrium");
    EXPECT_EQ(back.scene().meshes.size(), 12u);
    EXPECT_EQ(back.scene().source, "scene.obj");
}

TEST(bake, info_has_the_keys_that_scripts_use)
{
    const Folder folder;
    BakeOptions options;
    options.input = write_scene(folder);
    const BakeData bake = bake_scene(options);
    const auto json = nlohmann::json::parse(to_text(info_json(bake.scene, 123)));
    EXPECT_EQ(json.at("triangles"), 2400);
    EXPECT_EQ(json.at("bounds").at("max").size(), 3u);
    EXPECT_EQ(json.at("meshes").at(3).at("name"), "g3");
    EXPECT_EQ(json.at("meshes").at(3).at("material"), 3);
    EXPECT_EQ(json.at("meshes").at(3).at("two_sided"), true);
    EXPECT_EQ(json.at("materials").at(3).at("class"), "masked");
    for (const char* key : {"file", "width", "height", "format", "mips"})
        EXPECT_TRUE(json.at("textures").at(0).contains(key));
    EXPECT_EQ(json.at("warnings").at(0).at("kind"), "bump-colour");
    EXPECT_EQ(json.at("warnings").at(0).at("count"), 12);
    EXPECT_NE(info_text(bake.scene, 123).find("2400 triangles"), std::string::npos);
}

TEST(bake, texture_options)
{
    const Folder folder;
    BakeOptions options;
    options.input = write_scene(folder);
    options.max_texture_size = 16;
    options.textures = TextureEncoding::bc;
    const BakeData bake = bake_scene(options);
    for (const Texture& t : bake.scene.textures) {
        EXPECT_LE(std::max(t.width, t.height), 16u);
        EXPECT_TRUE(is_block_compressed(t.format));
    }
    write_bake(folder / "bc.atrium", bake); // checks sizes and offsets
    EXPECT_EQ(verify_bake(folder / "bc.atrium").size(), 4u);
}

TEST(bake, names_that_are_no_utf8_do_not_break_json)
{
    const Folder folder;
    const BakeData bake = test::bake_text(folder, "v 0 0 0\nv 1 0 0\nv 0 1 0\ng m\xFCll\nf 1 2 3\n");
    EXPECT_TRUE(nlohmann::json::accept(to_text(info_json(bake.scene, 1))));
}

TEST(bake, missing_libraries_warn_or_fail)
{
    const Folder folder;
    const std::string text = "mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    EXPECT_EQ(test::warnings_of(test::bake_text(folder, text), "mtl-missing"), 1u);
    BakeOptions strict;
    strict.strict = true;
    try {
        (void)test::bake_text(folder, text, strict);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::input);
        EXPECT_EQ(e.where(), "scene.obj:1, mtllib \"gone.mtl\"");
    }
}

/// Cut and damaged text must end, one way or the other.
TEST(bake, damaged_text_never_crashes)
{
    const Folder folder;
    const std::string whole = read_file(write_scene(folder)).substr(0, 3000);
    constexpr std::string_view odd("/-0 \n\\#.e9\tvf\0", 14);
    std::uint32_t state = 12345;
    const auto next = [&] { return state = state * 1664525u + 1013904223u; };
    for (int round = 0; round < 150; ++round) {
        std::string text = whole.substr(0, next() % whole.size());
        for (int k = 0; k < 8 && !text.empty(); ++k) text[next() % text.size()] = odd[(next() >> 8) % odd.size()];
        try {
            (void)test::bake_text(folder, text);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ExitCode::input);
        }
    }
}

} // namespace
} // namespace atrium
