// Set 2: a pass must declare what its shaders bind; each kind of mismatch is an error with both names.

#include "renderer/gpu/shader_interface.hpp"
#include "renderer/graph/bindings.hpp"
#include "tests/rig/device_rig.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace atrium::graph {
namespace {

constexpr const char* tonemap = "techniques/tonemap/tonemap.frag"; // binds one sampled image

/// A graph with an image and a buffer to read, and a pass "planted" that draws a picture with the tone operator.
struct Planted {
    Graph g;
    Tex image = g.texture("image", {gpu::Format::rgba16_float, 8, 8});
    Tex more = g.texture("more", {gpu::Format::rgba16_float, 8, 8});
    Buf buffer = g.buffer("buffer", 64);

    Planted()
    {
        for (const Tex texture : {image, more}) g.raster("fill").writes(texture, Load::clear).record([](Cmd&) {});
        g.transfer("fill buffer").writes(buffer).record([to = buffer](Cmd& cmd) { cmd.fill(to, 0); });
    }
    [[nodiscard]] PassBuilder pass()
    {
        const Tex picture = g.texture("picture", {gpu::Format::rgba8_srgb, 8, 8});
        return g.raster("planted").always().writes(picture);
    }
    /// The error message of running it; empty if it ran.
    std::string refusal()
    {
        try {
            static_cast<void>(rig::device().runner.run(g));
        } catch (const std::logic_error& e) {
            return e.what();
        }
        return {};
    }
};

void expect_names(const std::string& text, std::initializer_list<const char*> names)
{
    for (const char* name : names) EXPECT_NE(text.find(name), std::string::npos) << name << " is not in: " << text;
}

TEST(pass_bindings, what_agrees_runs)
{
    Planted right;
    right.pass().reads(right.image).fullscreen(tonemap, {0});
    EXPECT_EQ(right.refusal(), "");
}

TEST(pass_bindings, too_few_are_refused_with_both_names)
{
    Planted wrong;
    wrong.pass().fullscreen(tonemap, {0});
    expect_names(wrong.refusal(), {tonemap, "\"planted\"", "a sampled image at PASS_IMAGE(0)"});
}

TEST(pass_bindings, too_many_are_refused_with_both_names)
{
    Planted wrong;
    wrong.pass().reads(wrong.image).reads(wrong.more).fullscreen(tonemap, {0});
    expect_names(wrong.refusal(), {tonemap, "\"planted\"", "\"more\"", "PASS_IMAGE(1)"});
}

TEST(pass_bindings, another_kind_is_refused_with_both_names)
{
    Planted wrong;
    wrong.pass().reads(wrong.buffer).fullscreen(tonemap, {0});
    expect_names(wrong.refusal(), {tonemap, "\"planted\"", "a sampled image at PASS_IMAGE(0)"});
}

TEST(pass_bindings, sampled_and_storage_are_told_apart)
{
    Pass pass;
    pass.name = "planted";
    pass.kind = PassKind::compute;
    pass.uses = {{0, Access::sampled_compute}, {1, Access::storage_write}, {2, Access::storage_write}};
    const auto is_image = [](ResourceIndex r) { return r != 2; };
    const std::vector<BoundUse> bound = bind_uses(pass, is_image);
    ASSERT_EQ(bound.size(), 3u);
    EXPECT_EQ(bound[0].at, (gpu::PassBinding{0, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE}));
    EXPECT_EQ(bound[1].at, (gpu::PassBinding{32, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}));
    EXPECT_EQ(bound[2].at, (gpu::PassBinding{64, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}));

    const auto name = [](ResourceIndex r) { return "resource " + std::to_string(r); };
    ShaderBindings shader{"own.comp", {bound[0].at, bound[1].at, bound[2].at}};
    EXPECT_NO_THROW(check_bindings(pass, bound, {shader}, name));
    shader.bindings[0].type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    try {
        check_bindings(pass, bound, {shader}, name);
        ADD_FAILURE() << "a storage image passed for a sampled one";
    } catch (const std::logic_error& e) {
        expect_names(e.what(), {"own.comp binds a storage image", "\"planted\"", "\"resource 0\" as a sampled image"});
    }
}

TEST(pass_bindings, are_found_in_the_code)
{
    const auto found = gpu::find_pass_bindings(rig::find_shader("techniques/buffer_view/statistics_tiles.comp"));
    const std::vector<gpu::PassBinding> expected{{0, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE},
                                                 {32, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
    EXPECT_EQ(found, expected);
}

TEST(pass_bindings, more_passes_than_a_pool_of_sets_holds)
{
    Planted many;
    for (int i = 0; i < 600; ++i) many.pass().reads(many.image).fullscreen(tonemap, {0});
    EXPECT_EQ(many.refusal(), "");
}

} // namespace
} // namespace atrium::graph
