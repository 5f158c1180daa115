// Constant images, the results of techniques that are off.

#include "tests/gpu/graph_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace atrium {
namespace {

using rig::GraphRig;

/// One texel of a constant, copied to where it is read, and how many passes filled constants.
float read_constant(GraphRig& rig, float value, int& fills)
{
    graph::Graph g = rig.begin();
    const graph::Tex constant = g.constant(value);
    const gpu::Buffer target(rig::device().device, "texel", sizeof(float), VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                             gpu::MemoryUse::readback);
    const graph::Buf to = g.import("read back", target);
    g.keep(to, gpu::Access::host_read);
    g.transfer("read back").reads(constant).writes(to).record([=](graph::Cmd& cmd) { cmd.copy(constant, to); });
    const graph::RunStats stats = rig.runner.run(g);
    fills = static_cast<int>(stats.passes.size()) - 1;
    target.invalidate();
    float out = 0;
    std::memcpy(&out, target.mapped().data(), sizeof(out));
    return out;
}

TEST(constant_image, holds_its_value_and_is_filled_once)
{
    GraphRig rig;
    int fills = 0;
    EXPECT_EQ(read_constant(rig, 1, fills), 1);
    EXPECT_EQ(fills, 1);
    EXPECT_EQ(read_constant(rig, 1, fills), 1);
    EXPECT_EQ(fills, 0);
    EXPECT_EQ(read_constant(rig, 0.25f, fills), 0.25f);
    EXPECT_EQ(fills, 1);
    rig.runner.forget();
    EXPECT_EQ(read_constant(rig, 1, fills), 1);
    EXPECT_EQ(fills, 0) << "another scene does not change it";
}

TEST(constant_image, is_told_from_other_images_by_its_value)
{
    GraphRig rig;
    graph::Graph g = rig.begin();
    const graph::Tex one = g.constant(1), other = g.texture("other", {gpu::Format::r32_float, 4, 4});
    EXPECT_EQ(g.constant_value(one), 1.0f);
    EXPECT_EQ(g.constant_value(other), std::nullopt);
    EXPECT_EQ(g.constant(1).index, one.index);
    EXPECT_NE(g.constant(0).index, one.index);
    const graph::Tex array = g.constant_array(1);
    EXPECT_NE(array.index, one.index) << "shaders bind it as another kind of image";
    EXPECT_EQ(g.constant_value(array), 1.0f);
    EXPECT_TRUE(g.desc(array).array);
    const auto images = g.readable_images();
    EXPECT_TRUE(images.empty()) << "nobody wants to look at it";
}

} // namespace
} // namespace atrium
