// Plans of random graphs against the oracle: sound, and with nothing to spare.

#include "tests/graph/random_graph.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace atrium::graph {
namespace {

constexpr std::uint64_t graphs = 10000;

std::vector<oracle::Frame> two_frames(std::uint64_t seed)
{
    oracle::Frame first = random_frame(seed);
    first.plan = make_plan(first.graph, first.finals);
    oracle::Frame second = next_frame(first);
    second.plan = make_plan(second.graph, second.finals);
    return {first, second};
}

/// Whether the plan may be expected to know that the barrier is needed. What an imported resource went through in the
/// first frame comes to the second as one access and some stages: there it may wait more than it would have to. What a
/// transient waits for in the first frame may be a frame that never was.
bool must_be_needed(const oracle::Oracle& judge, const std::vector<oracle::Frame>& frames, const oracle::BarrierId& id)
{
    return frames[id.frame].graph.resources[judge.barrier(id).resource].transient == (id.frame == 1);
}

TEST(random_graphs, every_hazard_is_ordered_and_no_barrier_is_idle)
{
    std::size_t barriers = 0, tried = 0, passes = 0, dropped = 0, taken = 0, partial = 0, unstored = 0, histories = 0,
                resolves = 0, storage = 0, persistent = 0;
    for (std::uint64_t seed = 0; seed < graphs; ++seed) {
        const std::vector<oracle::Frame> frames = two_frames(seed);
        ASSERT_EQ(oracle::passes_problem(frames[0]), "") << "seed " << seed << "\n"
                                                         << to_text(frames[0].graph, frames[0].plan);
        ASSERT_EQ(oracle::placement_problem(frames[0]), "") << "seed " << seed << "\n"
                                                            << to_text(frames[0].graph, frames[0].plan);
        for (const oracle::Frame& frame : frames) {
            ASSERT_EQ(oracle::contents_problem(frame), "") << "seed " << seed << "\n"
                                                           << to_text(frame.graph, frame.plan);
            for (const PlannedPass& pass : frame.plan.passes) unstored += pass.unstored != 0;
        }
        const oracle::Oracle judge(frames);
        ASSERT_EQ(judge.problem(), "") << "seed " << seed << "\n"
                                       << to_text(frames[0].graph, frames[0].plan)
                                       << to_text(frames[1].graph, frames[1].plan);
        for (const oracle::BarrierId& id : judge.barriers()) {
            ++barriers;
            const Barrier& barrier = judge.barrier(id);
            taken += barrier.takes_memory;
            const ResourceDesc& resource = frames[0].graph.resources[barrier.resource];
            partial +=
                resource.is_image && (barrier.range.mips < resource.mips || barrier.range.layers < resource.layers);
            if (!must_be_needed(judge, frames, id)) continue;
            ++tried;
            ASSERT_NE(judge.problem_without(id), "")
                << "seed " << seed << ", frame " << id.frame << ", planned pass " << id.pass << ", barrier "
                << id.barrier << " is not needed\n"
                << to_text(frames[0].graph, frames[0].plan) << to_text(frames[1].graph, frames[1].plan);
        }
        for (const PlannedPass& pass : frames[1].plan.passes) {
            for (const Use& use : frames[1].graph.passes[pass.pass].uses) {
                const ResourceDesc& used = frames[1].graph.resources[use.resource];
                resolves += use.access == Access::resolve_write;
                storage += used.is_image && gpu::info(use.access).layout == VK_IMAGE_LAYOUT_GENERAL &&
                           use.access != Access::host_read;
                persistent += !used.initial_parts.empty();
                for (const auto& [now, before] : frames[1].histories) histories += use.resource == before;
            }
        }
        passes += frames[0].plan.passes.size();
        dropped += frames[0].plan.dropped.size();
    }
    // The graphs are no good if they leave out what is to be tested.
    EXPECT_GT(passes, 3 * graphs);
    EXPECT_GT(dropped, graphs);
    EXPECT_GT(tried, 5 * graphs);
    EXPECT_GT(taken, graphs / 2);
    EXPECT_GT(partial, graphs);
    EXPECT_GT(unstored, graphs / 4);
    EXPECT_GT(resolves, graphs / 4);
    EXPECT_GT(storage, graphs);
    EXPECT_GT(persistent, graphs);
    EXPECT_GT(histories, graphs / 20);
    RecordProperty("barriers", static_cast<int>(barriers));
    RecordProperty("barriers_left_out", static_cast<int>(tried));
}

TEST(random_graphs, plans_are_the_same_every_time)
{
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const std::vector<oracle::Frame> a = two_frames(seed), b = two_frames(seed);
        EXPECT_EQ(to_text(a[1].graph, a[1].plan), to_text(b[1].graph, b[1].plan)) << "seed " << seed;
    }
}

} // namespace
} // namespace atrium::graph
