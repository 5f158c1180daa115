#include "app/scene_writer.hpp"

#include "app/gui/view_model.hpp"
#include "tests/core/temp_folder.hpp"

#include <gtest/gtest.h>

namespace atrium::gui {
namespace {

/// A model of a scene that has everything a scene file can say.
void fill(ViewModel& model, const std::filesystem::path& folder)
{
    SceneFile& file = model.scene_file;
    file.bake = folder / "bakes" / "court.atrium";
    file.instances = {{file.bake, "lid", {0.1f, -2, 3}, {0, 45, 0}, 0.5f}, {"/elsewhere/pot.atrium", "", {}, {}, 1}};
    file.materials = {
        {"*\"fabric\"\\?", {{"class", "cloth"}, {"base_color", "0.1:1:0"}, {"two_sided", "on"}}},
        {"*", {{"roughness", "0.3"}}},
    };
    model.scene_materials.emplace_back().name = "stone";
    Material polished = model.scene_materials[0];
    polished.emission = {0, 1e-7f, 1e8f};
    model.set_material(0, polished);
    model.scene_file.cameras = {{"hero", {{1, 2, 3}, {4, 5, 6}, 70}}, {"window", {}}};
    for (const LightType type : {LightType::sun, LightType::spot, LightType::point, LightType::rect})
        model.add_light(type, {1, 0.1f, -3});
    model.lights[1].color = {1, 0.9f, 0.25f};
    model.lights[1].shadow = false;
    model.lights[3].up = {1, 0, 0};
    EXPECT_EQ(add_bookmark(model.bookmarks, "a \"door\"\t", {{-1e-3f, 0, 1e6f}, {0, 0, 0}, 1.5f}), std::nullopt);
    EXPECT_EQ(add_bookmark(model.bookmarks, "hero", {}), std::nullopt);
    model.camera = {{0.1f, 0.2f, 0.3f}, {1, 1, 1}, 33.3f};
    model.paths = {{"walk", {{0, {1, 2, 3}, {4, 5, 6}}, {1.5f, {0.1f, 2, 3}, {4, 5, 6e5f}}}},
                   {"a b.c", {{-1, {}, {1, 0, 0}}}}};
    model.settings.shadow.filter = ShadowFilter::reference;
    model.settings.debug.view = "light.a\"b";
    model.settings.sky.zenith = {0.1f, 1e-7f, 3e5f};
}

TEST(scene_writer, what_the_window_saves_it_reads_back)
{
    const test::TempFolder folder;
    ViewModel model;
    fill(model, folder.path());
    const auto file = folder.path() / "saved.toml";
    model.save_scene(file);
    const SceneFile read = read_scene_file(file);

    EXPECT_EQ(read.bake, model.scene_file.bake);
    EXPECT_EQ(read.lights, model.lights);
    EXPECT_EQ(read.paths, model.paths);
    const Bookmarks cameras{{"window", model.camera},
                            model.scene_file.cameras[0],
                            model.bookmarks[0],
                            {"hero_", model.bookmarks[1].second}};
    EXPECT_EQ(read.cameras, cameras);
    ASSERT_EQ(read.instances.size(), 2u);
    EXPECT_EQ(read.instances[0].mesh, "lid");
    EXPECT_EQ(read.instances[0].rotation.y, 45);
    EXPECT_EQ(read.instances[1].bake, "/elsewhere/pot.atrium");
    std::vector<MaterialOverride> materials = model.scene_file.materials;
    materials.push_back(model.materials.at(0)); // after those that it was changed from
    EXPECT_EQ(read.materials, materials);

    app::write_scene_file(folder / "again.toml", read);
    const SceneFile again = read_scene_file(folder / "again.toml");
    EXPECT_EQ(app::scene_toml(again, folder.path()), app::scene_toml(read, folder.path()));
}

TEST(scene_writer, settings_come_back_on_every_device)
{
    const test::TempFolder folder;
    for (const bool written_on_cpu : {false, true}) {
        ViewModel model;
        model.scene_file.bake = "court.atrium";
        model.apply_defaults(written_on_cpu);
        model.settings.ao.radius = 1.0f / 3.0f;
        const auto file = folder.path() / "saved.toml";
        model.save_scene(file);
        for (const bool read_on_cpu : {false, true}) {
            ViewModel other;
            other.apply_defaults(read_on_cpu);
            EXPECT_EQ(other.apply_texts(read_scene_file(file).settings), std::nullopt);
            EXPECT_EQ(other.settings_toml(), model.settings_toml());
        }
    }
}

TEST(scene_writer, a_file_that_cannot_be_written_is_told)
{
    const ViewModel model;
    EXPECT_THROW(model.save_scene(""), Error);
    EXPECT_THROW(model.save_scene("/nowhere/at/all.toml"), Error);
}

} // namespace
} // namespace atrium::gui
