// Bakes with damaged or hostile bulk data: nothing crashes, and the picture is a picture.

#include "renderer/core/error.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/scene/bake_rig.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

namespace atrium {
namespace {

using bake_rig::Bytes;

/// Draws a scene whose bulk section `s` holds the given words, all hashes right.
void draw_with(bake::Section s, const std::function<void(Bytes&)>& spoil)
{
    const std::filesystem::path file = rig::temporary_folder() / "spoilt.atrium";
    write_bake(file, truth::box_on_floor());
    Bytes bytes = bake_rig::section(bake_rig::read_bytes(file), s);
    spoil(bytes);
    bake_rig::write_bytes(file, bake_rig::with_section(bake_rig::read_bytes(file), s, bytes));
    rig::FrameRig rig(file);
    rig.request.size = {64, 36};
    rig.request.want_picture = true;
    rig.look({2, 2, 2}, {0, 0, 0});
    rig.light("sun");
    EXPECT_EQ(rig.render().picture.width, 64);
}

TEST(hostile_bulk, indices_far_beyond_the_vertices_are_drawn_harmlessly)
{
    draw_with(bake::indices, [](Bytes& b) { std::fill(b.begin(), b.end(), std::byte{0xff}); });
    std::mt19937 random(3);
    draw_with(bake::indices, [&](Bytes& b) {
        for (std::byte& byte : b) byte = static_cast<std::byte>(random());
    });
    draw_with(bake::indices, [](Bytes& b) {
        for (std::size_t i = 0; i + 4 <= b.size(); i += 4)
            bake_rig::put(b, i, 0x7fffffffu - static_cast<std::uint32_t>(i));
    });
}

TEST(hostile_bulk, vertices_of_infinities_and_nan_are_drawn_harmlessly)
{
    for (const float value : {INFINITY, -INFINITY, NAN, 1e38f, -1e-38f}) {
        draw_with(bake::vertices, [&](Bytes& b) {
            for (std::size_t i = 0; i + 4 <= b.size(); i += 4) bake_rig::put(b, i, value);
        });
    }
}

TEST(damage, in_header_table_and_archive_is_refused_by_name)
{
    const std::filesystem::path file = rig::temporary_folder() / "whole.atrium",
                                broken = rig::temporary_folder() / "broken.atrium";
    write_bake(file, truth::box_on_floor());
    const Bytes whole = bake_rig::read_bytes(file);
    const std::size_t archive = bake_rig::table(whole)[bake::archive].offset;
    for (const auto& [offset, name] : {std::pair<std::size_t, const char*>{3, "header"},
                                       {bake_rig::table_offset + 20, "table"},
                                       {archive + 60, "archive"}}) {
        Bytes bytes = whole;
        bytes[offset] ^= std::byte{1};
        bake_rig::write_bytes(broken, bytes);
        try {
            const rig::FrameRig rig(broken);
            FAIL() << name;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ExitCode::input);
            EXPECT_NE(e.text().find(name), std::string::npos) << e.text();
        }
    }
}

TEST(upload, staging_and_import_give_the_same_picture)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.want_picture = true;
    rig.light("sun");
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    const FrameResult imported = rig.render();
    rig::reset_engine();
    EngineOptions options;
    options.validate = true;
    options.upload = UploadPath::staging;
    Engine staged(options);
    SceneDescription scene;
    scene.bakes.push_back(&rig.bake());
    scene.instances.push_back({0, std::nullopt, mat4(1)});
    staged.load(scene);
    EXPECT_EQ(staged.render(rig.request).picture.values, imported.picture.values);
    EXPECT_EQ(staged.validation_messages(), 0u);
}

TEST(upload, loading_again_and_again_keeps_memory_level)
{
    rig::FrameRig first(rig::courtyard_bake());
    const std::uint64_t before = rig::engine().device().memory_in_use();
    for (int i = 0; i < 5; ++i) {
        const rig::FrameRig again(rig::courtyard_bake());
    }
    EXPECT_EQ(rig::engine().device().memory_in_use(), before);
}

} // namespace
} // namespace atrium
