// Placements of many transients at once, more crowded than the random graphs are.

#include "tests/graph/plan_oracle.hpp"
#include "tests/graph/small_graph.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace atrium::graph {
namespace {

oracle::Frame crowd(std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t n) { return random() % n; };
    SmallGraph g;
    constexpr std::uint64_t passes = 12, images = 24;
    for (std::uint64_t p = 0; p < passes; ++p) g.pass(fmt::format("p{}", p), {});
    for (std::uint64_t i = 0; i < images; ++i) {
        const auto r = g.image(fmt::format("i{}", i), 1 + below(100));
        g.desc.resources[r].alignment = std::uint64_t{1} << below(4);
        g.desc.resources[r].keep = below(20) == 0;
        const std::uint64_t first = below(passes), last = std::min(passes - 1, first + below(4));
        for (std::uint64_t p = first; p <= last; ++p)
            g.desc.passes[p].uses.push_back({r, Access::color_write, {}, p == first});
    }
    return {g.desc, {}, make_plan(g.desc)};
}

/// The most that lives at once: no placing can do with less.
std::uint64_t peak(const oracle::Frame& frame)
{
    std::uint64_t most = 0;
    std::vector<bool> begun(frame.graph.resources.size(), false);
    for (std::size_t p = 0; p < frame.graph.passes.size(); ++p) {
        std::uint64_t now = 0;
        std::vector<bool> used(begun.size(), false);
        for (const Use& use : frame.graph.passes[p].uses) used[use.resource] = begun[use.resource] = true;
        for (std::size_t r = 0; r < begun.size(); ++r) {
            if (used[r] || (begun[r] && frame.graph.resources[r].keep)) now += frame.graph.resources[r].size;
        }
        most = std::max(most, now);
    }
    return most;
}

TEST(random_placements, nothing_overlaps_and_most_memory_is_shared)
{
    std::uint64_t least = 0, used = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        const oracle::Frame frame = crowd(seed);
        ASSERT_EQ(oracle::placement_problem(frame), "") << "seed " << seed << "\n" << to_text(frame.graph, frame.plan);
        least += peak(frame);
        used = std::accumulate(frame.plan.block_sizes.begin(), frame.plan.block_sizes.end(), used);
    }
    RecordProperty("used_percent_of_least", static_cast<int>(100 * used / least));
    EXPECT_LT(used * 100, least * 110); // 1.047 times the least, measured
}

} // namespace
} // namespace atrium::graph
