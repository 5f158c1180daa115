// Shaders that are exchanged while the program runs: what fits is taken, what does not is refused and changes nothing.

#include "renderer/core/error.hpp"
#include "renderer/gpu/shader_interface.hpp"
#include "tests/rig/device_rig.hpp"

#include <gtest/gtest.h>

namespace atrium::gpu {
namespace {

const ShaderInterface built{{"set 2, binding 0", "image"}, {"push constants", "{ 0 float }"}, {"output 0", "vec4"}};

TEST(shader_interface, may_want_less_but_nothing_new_and_nothing_else)
{
    EXPECT_EQ(interface_conflict(built, built), std::nullopt);
    ShaderInterface fresh{{"output 0", "vec4"}};
    EXPECT_EQ(interface_conflict(built, fresh), std::nullopt);
    fresh["set 2, binding 1"] = "image";
    EXPECT_EQ(interface_conflict(built, fresh), "set 2, binding 1 is new");
    fresh = {{"output 0", "vec4"}, {"push constants", "{ 4 float }"}};
    EXPECT_EQ(interface_conflict(built, fresh), "another layout or type of push constants");
    EXPECT_EQ(interface_conflict(built, {}), "output 0 is missing");
}

TEST(shader_interface, is_found_in_the_code)
{
    const ShaderInterface found = find_interface(rig::find_shader("techniques/lighting/lighting.frag"));
    for (const char* item : {"set 1, binding 0", "set 2, binding 0", "push constants", "output 0"})
        EXPECT_TRUE(found.contains(item)) << item;
    EXPECT_EQ(find_interface(rig::find_shader("techniques/culling/cull.comp")).at("work group"), "64 x 1 x 1");
    EXPECT_THROW(static_cast<void>(find_interface({})), Error);
}

TEST(pipelines, replace_takes_what_fits_and_keeps_the_rest)
{
    Pipelines& pipelines = rig::device().pipelines;
    ComputePipelineDesc desc{"techniques/culling/cull_visible.comp", {}};
    desc.pass_layout = rig::device().descriptors.pass_layout(pipelines.pass_bindings(desc.shader));
    const VkPipeline before = pipelines.get(desc);
    EXPECT_THROW(pipelines.replace(desc.shader, rig::find_shader("techniques/sky/sky.frag")), Error);
    EXPECT_EQ(pipelines.get(desc), before);
    EXPECT_NO_THROW(pipelines.replace(desc.shader, rig::find_shader(desc.shader)));
    EXPECT_NE(pipelines.get(desc), VkPipeline(VK_NULL_HANDLE));
}

} // namespace
} // namespace atrium::gpu
