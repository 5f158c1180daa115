// What `assetconv courtyard` leaves in its folder: textures, OBJ, MTL and scene file that belong together.
#include "assetconv/courtyard/courtyard.hpp"
#include "assetconv/courtyard/materials.hpp"
#include "assetconv/courtyard/textures/noise.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/image.hpp"
#include "renderer/core/jobs.hpp"
#include "renderer/scene/scene_file.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include <unistd.h>

namespace atrium {
namespace {

namespace fs = std::filesystem;

/// A folder that goes away with the test.
struct Folder {
    fs::path path;
    explicit Folder(const std::string& name)
        : path(fs::temp_directory_path() / (name + "_" + std::to_string(::getpid())))
    {
        fs::remove_all(path);
    }
    ~Folder() { fs::remove_all(path); }
};

std::string read(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::map<std::string, std::string> contents(const fs::path& folder)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files[fs::relative(entry.path(), folder).string()] = read(entry.path());
        }
    }
    return files;
}

/// Written once for all tests: low detail, seed 1.
const Folder& written()
{
    static const Folder folder = [] {
        Folder f("atrium_courtyard");
        write_courtyard({.folder = f.path, .detail = CourtyardOptions::Detail::low});
        return f;
    }();
    return folder;
}

std::set<std::string> maps_of_mtl()
{
    std::set<std::string> maps;
    std::istringstream mtl(read(written().path / "courtyard.mtl"));
    for (std::string line; std::getline(mtl, line);) {
        if (const auto at = line.find("textures/"); at != std::string::npos) {
            maps.insert(line.substr(at));
        }
    }
    return maps;
}

TEST(courtyard_files, every_texture_is_named_and_every_name_has_its_texture)
{
    const std::set<std::string> maps = maps_of_mtl();
    std::set<std::string> files;
    for (const auto& entry : fs::directory_iterator(written().path / "textures")) {
        files.insert("textures/" + entry.path().filename().string());
    }
    EXPECT_EQ(maps, files);
    EXPECT_GE(maps.size(), 40u);
    for (const std::string& map : maps) {
        const Image8 image = read_png(written().path / map);
        EXPECT_EQ(image.width, image.height) << map;
        EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(image.width))) << map;
        EXPECT_LE(image.width, 256) << map;
    }
}

TEST(courtyard_files, normal_maps_are_unit_normals_that_look_out)
{
    int seen = 0;
    for (const std::string& map : maps_of_mtl()) {
        if (map.find("_normal") == std::string::npos) {
            continue;
        }
        ++seen;
        const Image8 image = read_png(written().path / map);
        ASSERT_EQ(image.channels, 3) << map;
        double sum_x = 0, sum_y = 0, rough = 0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const std::uint8_t* p = image.at(x, y);
                const vec3 n = 2.0f * vec3(p[0], p[1], p[2]) / 255.0f - 1.0f;
                ASSERT_NEAR(glm::length(n), 1.0f, 0.012f) << map; // three roundings to 1/255
                ASSERT_GT(n.z, 0.0f) << map;
                sum_x += static_cast<double>(n.x / n.z);
                sum_y += static_cast<double>(n.y / n.z);
                rough += static_cast<double>(glm::length(vec2(n)));
            }
        }
        // The slopes of a tile that repeats sum to nothing, but for rounding; and there is something to see.
        const double texels = static_cast<double>(image.width) * image.height;
        EXPECT_LT(std::abs(sum_x) / texels, 0.01) << map;
        EXPECT_LT(std::abs(sum_y) / texels, 0.01) << map;
        EXPECT_GT(rough / texels, 0.01) << map;
    }
    EXPECT_GE(seen, 12);
}

TEST(courtyard_files, textures_repeat_without_a_seam)
{
    // Across the border the colour may jump as much as between the roughest neighbouring columns inside, not more.
    int seen = 0;
    for (const std::string& map : maps_of_mtl()) {
        if (map.find("atlas") != std::string::npos || map.find("mask") != std::string::npos) {
            continue;
        }
        const Image8 image = read_png(written().path / map);
        const auto step = [&](int x) {
            double sum = 0;
            for (int y = 0; y < image.height; ++y) {
                for (int c = 0; c < image.channels; ++c) {
                    sum += std::abs(image.at(x, y)[c] - image.at((x + 1) % image.width, y)[c]);
                }
            }
            return sum;
        };
        double most = 0;
        for (int x = 0; x + 1 < image.width; ++x) {
            most = std::max(most, step(x));
        }
        EXPECT_LE(step(image.width - 1), 1.15 * most) << map;
        ++seen;
    }
    EXPECT_GE(seen, 30);
}

TEST(courtyard_files, leaves_have_a_mask_and_fronds_an_alpha)
{
    for (const char* map : {"textures/leaf_mask.png", "textures/frond_atlas.png"}) {
        const Image8 image = read_png(written().path / map);
        std::size_t clear = 0, solid = 0;
        for (std::size_t i = static_cast<std::size_t>(image.channels) - 1; i < image.values.size();
             i += static_cast<std::size_t>(image.channels)) {
            clear += image.values[i] < 10;
            solid += image.values[i] > 245;
        }
        const std::size_t texels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
        EXPECT_GT(clear * 5, texels) << map; // at least a fifth of each
        EXPECT_GT(solid * 5, texels) << map;
    }
}

TEST(courtyard_files, obj_refers_to_its_own_corners_and_materials)
{
    std::set<std::string> known;
    for (const courtyard::MaterialInfo& m : courtyard::materials()) {
        known.insert(m.name);
    }
    std::istringstream obj(read(written().path / "courtyard.obj"));
    std::size_t positions = 0, coordinates = 0, normals = 0, faces = 0, largest = 0;
    bool library = false;
    for (std::string line; std::getline(obj, line);) {
        library |= line == "mtllib courtyard.mtl";
        positions += line.starts_with("v ");
        coordinates += line.starts_with("vt ");
        normals += line.starts_with("vn ");
        if (line.starts_with("usemtl ")) {
            EXPECT_TRUE(known.contains(line.substr(7))) << line;
        }
        if (!line.starts_with("f ")) {
            continue;
        }
        ++faces;
        std::size_t a = 0, b = 0, c = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "f %zu/%*u/%*u %zu/%*u/%*u %zu/", &a, &b, &c), 3) << line;
        EXPECT_GE(std::min({a, b, c}), 1u);
        largest = std::max({largest, a, b, c});
        EXPECT_LE(largest, positions); // corners stand before the faces that use them
    }
    EXPECT_TRUE(library);
    EXPECT_EQ(positions, coordinates);
    EXPECT_EQ(positions, normals);
    EXPECT_EQ(largest, positions);
    EXPECT_GT(faces, 10'000u);
}

TEST(courtyard_files, scene_file_has_cameras_and_lights)
{
    const SceneFile scene = read_scene_file(written().path / "courtyard.toml");
    EXPECT_EQ(scene.bake.filename(), "courtyard.atrium");
    ASSERT_GE(scene.cameras.size(), 4u);
    EXPECT_LE(scene.cameras.size(), 6u);
    EXPECT_EQ(scene.cameras.front().first, "hero");
    ASSERT_GE(scene.lights.size(), 2u);
    EXPECT_LE(scene.lights.size(), 6u);
    EXPECT_EQ(scene.lights.front().type, LightType::sun);
}

TEST(courtyard_files, same_seed_gives_the_same_bytes_on_any_number_of_threads)
{
    Folder again("atrium_courtyard_again"), other("atrium_courtyard_other");
    set_job_threads(1);
    write_courtyard({.folder = again.path, .detail = CourtyardOptions::Detail::low});
    set_job_threads(0);
    write_courtyard({.folder = other.path, .seed = 2, .detail = CourtyardOptions::Detail::low});
    const auto first = contents(written().path), second = contents(again.path), third = contents(other.path);
    ASSERT_EQ(first.size(), second.size());
    for (const auto& [name, bytes] : first) {
        EXPECT_EQ(bytes == second.at(name), true) << name;
        const bool fixed = name == "courtyard.mtl" || name == "courtyard.toml"; // the plan's, not the weather's
        if (!name.ends_with(".png")) {
            EXPECT_EQ(bytes == third.at(name), fixed) << name;
        }
    }
    EXPECT_NE(first.at("textures/ashlar.png"), third.at("textures/ashlar.png"));
}

TEST(courtyard_files, a_folder_that_cannot_be_made_is_an_error_of_the_environment)
{
    Folder folder("atrium_courtyard_blocked");
    fs::create_directories(folder.path);
    std::ofstream(folder.path / "file") << "in the way";
    try {
        write_courtyard({.folder = folder.path / "file" / "court"});
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::environment);
        EXPECT_NE(e.text().find("file"), std::string::npos);
    }
}

TEST(courtyard_noise, repeats_and_has_no_mean)
{
    const courtyard::Noise noise(7);
    double sum = 0;
    for (int i = 0; i < 4096; ++i) {
        const vec2 uv((static_cast<float>(i % 64) + 0.3f) / 64, (static_cast<float>(i / 64) + 0.7f) / 64);
        const float here = noise.fbm(uv, ivec2(5, 3), 4);
        sum += static_cast<double>(here);
        ASSERT_NEAR(here, noise.fbm(uv + vec2(1, 0), ivec2(5, 3), 4), 2e-3f);
        ASSERT_NEAR(here, noise.fbm(uv - vec2(0, 2), ivec2(5, 3), 4), 2e-3f);
        ASSERT_NEAR(noise.worley(uv, ivec2(6)).nearest, noise.worley(uv + vec2(1, 1), ivec2(6)).nearest, 1e-3f);
    }
    EXPECT_LT(std::abs(sum / 4096), 0.05);
}

} // namespace
} // namespace atrium
