// Who shares memory with whom, and what that makes them wait for.

#include "tests/graph/small_graph.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace atrium::graph {
namespace {

/// A chain in which each image is made from the one before.
SmallGraph chain(const std::vector<std::uint64_t>& sizes)
{
    SmallGraph g;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const auto made = g.image(fmt::format("i{}", i), sizes[i]);
        std::vector<Use> uses{{made, A::color_write, {}, true}};
        if (i > 0) uses.push_back({made - 1, A::sampled_fragment});
        g.pass(fmt::format("p{}", i), uses);
    }
    return g;
}

TEST(aliasing, a_chain_needs_two_places)
{
    const Plan plan = make_plan(chain({100, 100, 100, 100}).desc);
    EXPECT_EQ(plan.block_sizes, (std::vector<std::uint64_t>{100, 100}));
    for (ResourceIndex r = 0; r < 4; ++r) EXPECT_EQ(plan.placements[r].block, r % 2);
}

TEST(aliasing, the_next_occupant_waits_for_the_last_uses_of_the_one_before)
{
    const SmallGraph g = chain({100, 100, 100, 100});
    const Plan plan = make_plan(g.desc);
    // i2 takes over from i0, which was written, then read in fragment shaders: all its readers, no access.
    const Barrier& takes = plan.passes[2].barriers[0];
    EXPECT_EQ(takes.resource, 2u);
    EXPECT_EQ(takes.src_stages, fragment);
    EXPECT_EQ(takes.src_access, 0u);
    EXPECT_EQ(takes.dst_stages, color);
    EXPECT_EQ(takes.old_layout, VK_IMAGE_LAYOUT_UNDEFINED);
    EXPECT_TRUE(takes.takes_memory);
    // i3, never read, leaves a write behind: i1 of the next frame waits for that, too.
    const Barrier& next = plan.passes[1].barriers[0];
    EXPECT_EQ(next.resource, 1u);
    EXPECT_EQ(next.src_stages, fragment | color);
    EXPECT_EQ(next.src_access, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
}

TEST(aliasing, waits_for_every_occupant_that_it_overlaps)
{
    SmallGraph g;
    const auto a = g.image("a", 50), b = g.image("b", 50), apart = g.image("apart", 50), big = g.image("big", 100);
    g.pass("small", {{a, A::color_write, {}, true}, {b, A::storage_write, {}, true}});
    g.pass("read", {{a, A::sampled_vertex}});
    g.pass("big", {{big, A::transfer_write, {}, true}, {apart, A::depth_write, {}, true}});
    const Plan plan = make_plan(g.desc);
    EXPECT_EQ(plan.block_sizes, (std::vector<std::uint64_t>{100, 50}));
    EXPECT_EQ(plan.placements[a].block, 0u);
    EXPECT_EQ(plan.placements[b].block, 0u);
    EXPECT_EQ(plan.placements[apart].block, 1u);
    const Barrier& takes = plan.passes[2].barriers[0];
    EXPECT_EQ(takes.resource, big);
    // its own last use, in the frame before, is among them
    EXPECT_EQ(takes.src_stages, VK_PIPELINE_STAGE_2_PRE_RASTERIZATION_SHADERS_BIT | compute | transfer);
    EXPECT_EQ(takes.src_access, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT);
    EXPECT_FALSE(plan.passes[2].barriers[1].takes_memory);
}

TEST(aliasing, a_buffer_waits_for_its_own_last_frame)
{
    SmallGraph g;
    const auto b = g.buffer("b");
    g.pass("w", {{b, A::storage_write, {}, true}});
    g.pass("r", {{b, A::indirect_read}});
    const Plan plan = make_plan(g.desc);
    ASSERT_EQ(plan.passes[0].barriers.size(), 1u);
    EXPECT_EQ(plan.passes[0].barriers[0].src_stages, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT);
    EXPECT_EQ(plan.passes[0].barriers[0].src_access, 0u);
    EXPECT_FALSE(plan.passes[0].barriers[0].takes_memory);
    EXPECT_EQ(plan.placements[b].block, ~0u);
}

TEST(aliasing, classes_stay_apart)
{
    SmallGraph g = chain({100, 100, 100});
    g.desc.resources[2].memory_class = 1;
    const Plan plan = make_plan(g.desc);
    EXPECT_EQ(plan.block_class, (std::vector<std::uint32_t>{0, 0, 1}));
    EXPECT_EQ(plan.placements[2].block, 2u);
}

TEST(aliasing, kept_and_final_resources_share_with_nobody_after_them)
{
    for (const bool by_final : {false, true}) {
        SmallGraph g = chain({100, 100, 100, 100});
        g.desc.resources[0].keep = !by_final;
        std::vector<FinalUse> finals;
        if (by_final) finals = {{0, A::host_read}};
        const Plan plan = make_plan(g.desc, finals);
        for (ResourceIndex r = 1; r < 4; ++r) EXPECT_NE(plan.placements[r].block, plan.placements[0].block);
        // but may stand where another was before
        SmallGraph late = chain({100, 100, 100, 100});
        late.desc.resources[3].keep = true;
        EXPECT_EQ(make_plan(late.desc).block_sizes.size(), 2u);
    }
}

TEST(aliasing, offsets_are_aligned)
{
    SmallGraph g;
    const auto a = g.add({.name = "a", .size = 10, .alignment = 1}),
               b = g.add({.name = "b", .size = 10, .alignment = 16});
    const auto big = g.image("big", 64);
    g.pass("big", {{big, A::color_write, {}, true}});
    g.pass("both", {{a, A::color_write, {}, true}, {b, A::color_write, {}, true}});
    const Plan plan = make_plan(g.desc);
    EXPECT_EQ(plan.placements[a].offset, 0u);
    EXPECT_EQ(plan.placements[b].offset, 16u);
    EXPECT_EQ(plan.placements[b].block, plan.placements[big].block);
    EXPECT_EQ(plan.block_alignment, std::vector<std::uint64_t>{16});
}

TEST(aliasing, gaps_are_used_where_they_are_wide_enough)
{
    // a, b and c stand side by side where big was; then b's place, from 40 to 60, is free, and all from 80.
    for (const auto& [size, offset] : {std::pair<std::uint64_t, std::uint64_t>{20, 40}, {15, 40}}) {
        SmallGraph g;
        const auto big = g.image("big", 100), a = g.image("a", 40), b = g.image("b", 20), c = g.image("c", 20);
        const auto late = g.image("late", size);
        g.pass("big", {{big, A::color_write, {}, true}});
        g.pass("abc", {{a, A::color_write, {}, true}, {b, A::color_write, {}, true}, {c, A::color_write, {}, true}});
        g.pass("ac", {{a, A::color_write}, {c, A::color_write}, {late, A::color_write, {}, true}});
        const Plan plan = make_plan(g.desc);
        EXPECT_EQ(plan.block_sizes.size(), 1u);
        EXPECT_EQ(plan.placements[c].offset, 60u);
        EXPECT_EQ(plan.placements[late].offset, offset);
    }
}

TEST(aliasing, gaps_too_small_are_passed_over)
{
    SmallGraph g;
    const auto big = g.image("big", 100), a = g.image("a", 41), c = g.image("c", 40), late = g.image("late", 10);
    g.desc.resources[c].alignment = 16;
    g.pass("big", {{big, A::color_write, {}, true}});
    g.pass("all", {{a, A::color_write, {}, true}, {c, A::color_write, {}, true}, {late, A::color_write, {}, true}});
    const Plan plan = make_plan(g.desc);
    EXPECT_EQ(plan.placements[c].offset, 48u);
    EXPECT_EQ(plan.placements[late].offset, 88u);
}

TEST(aliasing, dropped_and_imported_resources_have_no_place)
{
    SmallGraph g;
    const auto lost = g.image("lost", 10), out = g.imported_image("out", A::none);
    g.pass_if_wanted("dropped", {{lost, A::color_write, {}, true}});
    g.pass("p", {{out, A::color_write, {}, true}});
    const Plan plan = make_plan(g.desc);
    EXPECT_EQ(plan.placements[lost].block, ~0u);
    EXPECT_EQ(plan.placements[out].block, ~0u);
    EXPECT_TRUE(plan.block_sizes.empty());
}

} // namespace
} // namespace atrium::graph
