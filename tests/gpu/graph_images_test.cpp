// Mips and layers, multisampling and persistent resources of the graph, on the device.

#include "tests/gpu/graph_rig.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace atrium::graph {
namespace {

using gpu::Format;
using rig::GraphRig;

constexpr TexDesc tiny{Format::rgba32_float, 4, 2};

float first(const std::vector<float>& values)
{
    for (const float v : values) EXPECT_EQ(v, values.front());
    return values.front();
}

TEST(graph_images, layers_and_mips_are_written_one_by_one)
{
    GraphRig rig;
    for (std::uint32_t mip = 0; mip < 3; ++mip) {
        Graph g = rig.begin();
        const Tex image =
            g.texture("parts", {.format = Format::rgba32_float, .width = 4, .height = 4, .mips = all_mips});
        ASSERT_EQ(g.desc(image).mips, 3u);
        for (std::uint32_t m = 0; m < 3; ++m)
            g.raster("fill").writes_mip(image, m, Load::clear, vec4(1 + static_cast<float>(m)));
        const std::vector<float> out = rig.run(g, image, mip);
        EXPECT_EQ(out.size(), std::size_t{4} * (4u >> mip) * (4u >> mip));
        EXPECT_EQ(first(out), 1 + static_cast<float>(mip));
        EXPECT_EQ(rig.runner.plan().dropped.size(), 2u) << "the other mips";
    }
}

TEST(graph_images, sizes_follow_the_view)
{
    Graph g(FrameInfo{{641, 359}, {1282, 718}});
    const Tex half = g.texture("half", render_sized(Format::r8_unorm, 2)),
              whole = g.texture("whole", output_sized(Format::r8_unorm));
    EXPECT_EQ(g.size(half), uvec2(321, 180));
    EXPECT_EQ(g.size(half, 1), uvec2(160, 90));
    EXPECT_EQ(g.size(whole), uvec2(1282, 718));
    Graph nowhere;
    EXPECT_THROW(static_cast<void>(nowhere.texture("half", render_sized(Format::r8_unorm))), std::logic_error);
}

TEST(graph_images, samples_are_resolved_to_their_mean)
{
    GraphRig rig;
    Graph g = rig.begin();
    TexDesc four = tiny;
    four.format = Format::rgba16_float;
    const Tex resolved = g.texture("resolved", four);
    four.samples = 4;
    const Tex samples = g.texture("samples", four);
    g.raster("draw").writes(samples, Load::clear).resolves(resolved).fullscreen("gpu/one_sample.frag");
    const Tex values = g.texture("values", tiny);
    g.raster("widen").reads(resolved).reads(resolved).writes(values).fullscreen("examples/average.frag", {}, 1.0f);
    EXPECT_EQ(first(rig.run(g, values)), 0.25f);
    EXPECT_NE(rig.runner.plan_text().find("writes samples: color_write, discards, not stored"), std::string::npos)
        << rig.runner.plan_text();
}

/// One frame that writes `value` to the persistent image, or only reads it; returns its contents.
float persist(GraphRig& rig, std::optional<float> value, const std::string& view = "main")
{
    Graph g = rig.begin({.view = view});
    const Tex kept = g.persistent("kept", tiny, {.owner = Owner::scene});
    if (value) {
        g.raster("write").writes(kept, Load::clear, vec4(*value));
        g.note(kept, *value);
    } else {
        EXPECT_TRUE(g.holds(kept));
    }
    return first(rig.run(g, kept));
}

/// Runs frames of a view that declare nothing.
void idle(GraphRig& rig, int frames, const std::string& view = "main")
{
    for (int i = 0; i < frames; ++i) {
        Graph g = rig.begin({.view = view});
        static_cast<void>(rig.run(g, rig.plain(g, {1, 1}, 0)));
    }
}

bool holds(GraphRig& rig)
{
    Graph g = rig.begin();
    return g.holds(g.persistent("kept", tiny, {.owner = Owner::scene}));
}

TEST(persistent, holds_what_it_held_with_its_note)
{
    GraphRig rig;
    EXPECT_FALSE(holds(rig));
    EXPECT_EQ(persist(rig, 3), 3);
    EXPECT_EQ(persist(rig, {}), 3);
    EXPECT_EQ(persist(rig, {}, "other"), 3) << "views share it";
    Graph g = rig.begin();
    const Tex kept = g.persistent("kept", tiny, {.owner = Owner::scene});
    EXPECT_EQ(g.noted<float>(kept), 3);
    EXPECT_EQ(g.noted<double>(kept), std::nullopt);
    EXPECT_FALSE(g.kept("nothing"));
    ASSERT_TRUE(g.kept("kept"));
    EXPECT_EQ(g.kept("kept")->index, kept.index);
    TexDesc other = tiny;
    other.width = 5;
    EXPECT_THROW(static_cast<void>(g.persistent("kept", other, {.owner = Owner::scene})), std::logic_error);
}

TEST(persistent, must_be_written_before_it_is_read)
{
    GraphRig rig;
    Graph g = rig.begin();
    EXPECT_THROW(static_cast<void>(rig.run(g, g.persistent("kept", tiny))), std::logic_error);
    Graph alone;
    EXPECT_THROW(static_cast<void>(alone.persistent("kept", tiny)), std::logic_error);
}

TEST(persistent, is_released_after_frames_of_its_view_that_do_not_declare_it)
{
    GraphRig rig;
    persist(rig, 1);
    idle(rig, 50, "interface");
    EXPECT_TRUE(holds(rig)) << "frames of another view do not count";
    idle(rig, 7);
    EXPECT_TRUE(holds(rig));
    EXPECT_EQ(persist(rig, {}), 1);
    idle(rig, 8);
    EXPECT_FALSE(holds(rig));
    persist(rig, 1);
    rig.runner.forget();
    EXPECT_FALSE(holds(rig));
}

TEST(persistent, a_frame_that_fails_changes_nothing)
{
    GraphRig rig;
    persist(rig, 2);
    for (const bool while_recording : {false, true}) {
        Graph g = rig.begin();
        const Tex kept = g.persistent("kept", tiny, {.owner = Owner::scene});
        g.raster("write").writes(kept, Load::clear, vec4(9)).record([=](Cmd&) {
            if (while_recording) throw std::runtime_error("planted");
        });
        g.note(kept, 9.0f);
        const Tex unwritten = g.texture("unwritten", tiny);
        if (!while_recording) g.compute("reads what nobody wrote").reads(unwritten).always();
        EXPECT_ANY_THROW(static_cast<void>(rig.runner.run(g)));
        EXPECT_TRUE(holds(rig));
        Graph next = rig.begin();
        EXPECT_EQ(next.noted<float>(next.persistent("kept", tiny, {.owner = Owner::scene})), 2);
    }
    EXPECT_EQ(persist(rig, {}), 2);
    GraphRig fresh;
    {
        Graph g = fresh.begin();
        const Tex kept = g.persistent("kept", tiny, {.owner = Owner::scene});
        g.raster("write").writes(kept, Load::clear).record([](Cmd&) { throw std::runtime_error("planted"); });
        EXPECT_ANY_THROW(static_cast<void>(fresh.runner.run(g)));
    }
    EXPECT_FALSE(holds(fresh)) << "what was not executed is not valid";
    EXPECT_EQ(persist(fresh, 4), 4);
}

/// Whether the history is valid in a frame that writes `value`, and what it held.
std::pair<bool, std::optional<float>> history(GraphRig& rig, float value, const FrameInfo& frame = {},
                                              bool fails = false)
{
    Graph g = rig.begin(frame);
    const Tex now = g.persistent("pair", tiny);
    const auto [before, valid] = g.history(now);
    EXPECT_FALSE(g.holds(now));
    const std::optional<float> noted = before ? g.noted<float>(before) : std::nullopt;
    g.note(now, value);
    g.raster("write").writes(now, Load::clear, vec4(value)).record([=](Cmd&) {
        if (fails) throw std::runtime_error("planted");
    });
    if (fails) {
        EXPECT_ANY_THROW(static_cast<void>(rig.runner.run(g)));
    } else if (before) {
        const float held = first(rig.run(g, before));
        EXPECT_EQ(noted, held);
        return {valid, held};
    } else {
        static_cast<void>(rig.run(g, now));
    }
    return {valid, noted};
}

TEST(history, is_of_the_frame_before)
{
    GraphRig rig;
    using Result = std::pair<bool, std::optional<float>>;
    EXPECT_EQ(history(rig, 1), Result(false, std::nullopt));
    EXPECT_EQ(history(rig, 2), Result(true, 1));
    EXPECT_EQ(history(rig, 3), Result(true, 2));
    EXPECT_EQ(history(rig, 4, {.cut = true}), Result(false, 3)) << "a cut";
    EXPECT_EQ(history(rig, 5), Result(true, 4));
    EXPECT_EQ(history(rig, 6, {.view = "other"}), Result(false, std::nullopt)) << "another view's";
    EXPECT_EQ(history(rig, 7), Result(true, 5));
    EXPECT_EQ(history(rig, 8, {}, true), Result(true, 7)) << "this frame fails";
    EXPECT_EQ(history(rig, 9), Result(true, 7)) << "and the next goes on from before";
    idle(rig, 1);
    EXPECT_EQ(history(rig, 10), Result(false, 9)) << "not the frame before's";
    EXPECT_EQ(history(rig, 11), Result(true, 10));
}

TEST(history, of_buffers_swaps_too)
{
    GraphRig rig;
    for (int frame = 0; frame < 4; ++frame) {
        Graph g = rig.begin();
        const Buf now = g.persistent("words", std::uint64_t{16});
        const auto [before, valid] = g.history(now);
        EXPECT_EQ(valid, frame > 0);
        g.transfer("fill").writes(now).record([=](Cmd& cmd) { cmd.fill(now, static_cast<std::uint32_t>(frame)); });
        const gpu::Buffer target(rig::device().device, "target", 16, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                 gpu::MemoryUse::readback);
        const Buf to = g.import("target", target);
        g.keep(to, gpu::Access::host_read);
        const Buf from = valid ? before : now;
        g.transfer("read").reads(from).writes(to).record([=](Cmd& cmd) { cmd.copy(from, to, 16); });
        static_cast<void>(rig.runner.run(g));
        target.invalidate();
        EXPECT_EQ(static_cast<int>(target.mapped()[0]), std::max(frame - 1, 0));
    }
}

TEST(history, needs_a_persistent_resource)
{
    GraphRig rig;
    Graph g = rig.begin();
    EXPECT_THROW(static_cast<void>(g.history(g.texture("transient", tiny))), std::logic_error);
}

} // namespace
} // namespace atrium::graph
