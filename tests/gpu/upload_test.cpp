// Buffers that the host writes for one frame.

#include "renderer/graph/frame_slot.hpp"
#include "tests/gpu/graph_rig.hpp"

#include <gtest/gtest.h>

namespace atrium {
namespace {

TEST(uploads, a_frame_uses_the_memory_of_the_frame_before)
{
    graph::Uploads uploads(rig::device().device);
    const gpu::Buffer& first = uploads.next(100);
    const gpu::Buffer& second = uploads.next(100);
    EXPECT_NE(first.handle(), second.handle());
    EXPECT_GE(first.size(), 100u);

    uploads.begin();
    EXPECT_EQ(uploads.next(first.size()).handle(), first.handle());
    EXPECT_GE(uploads.next(1 << 20).size(), std::uint64_t{1} << 20);
}

TEST(uploads, each_holds_what_was_given_last)
{
    rig::GraphRig rig;
    for (const float value : {1.0f, 2.0f}) { // the second frame in the memory of the first
        graph::Graph g = rig.begin();
        const graph::Tex image = rig.upload(g, uvec2(2, 1), std::vector<float>(8, value));
        static_cast<void>(rig.upload(g, uvec2(2, 1), std::vector<float>(8, -value)));
        EXPECT_EQ(rig.run(g, image), std::vector<float>(8, value));
    }
}

TEST(uploads, need_a_runner)
{
    graph::Graph g;
    EXPECT_THROW(static_cast<void>(g.upload("numbers", std::vector<float>(4))), std::logic_error);
}

} // namespace
} // namespace atrium
