// Known small graphs and the exact barriers that Vulkan asks for, written in Vulkan's own words rather than from the
// table of accesses.

#include "tests/graph/small_graph.hpp"

#include <gtest/gtest.h>

namespace atrium::graph {
namespace {

using Barriers = std::vector<Barrier>;

constexpr auto none = VK_PIPELINE_STAGE_2_NONE;
constexpr auto indirect = VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT;
constexpr auto tests = VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr auto storage_write = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
constexpr auto color_write = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
constexpr auto color_both = color_write | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT;
constexpr auto depth_read = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
constexpr auto depth_write = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
constexpr auto color_layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
constexpr auto depth_layout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
constexpr auto depth_read_layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL;
constexpr auto present_layout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;

Barrier on(ResourceIndex r, Scope source, Scope destination, VkImageLayout before = undefined,
           VkImageLayout after = undefined)
{
    Barrier b;
    b.resource = r;
    b.src_stages = source.stages;
    b.src_access = source.access;
    b.dst_stages = destination.stages;
    b.dst_access = destination.access;
    b.old_layout = before;
    b.new_layout = after;
    return b;
}

/// By planned pass, and at the end of the frame.
std::vector<Barriers> barriers(const SmallGraph& g, const std::vector<FinalUse>& finals = {})
{
    const Plan plan = make_plan(g.desc, finals);
    std::vector<Barriers> out;
    for (const PlannedPass& p : plan.passes) out.push_back(p.barriers);
    if (!finals.empty()) out.push_back(plan.final_barriers);
    return out;
}

TEST(plan, buffer_read_after_write_waits_and_makes_visible)
{
    SmallGraph g;
    const auto b = g.imported_buffer("b", A::none);
    g.pass("cull", {{b, A::storage_write}});
    g.pass("draw", {{b, A::indirect_read}});
    const Barriers expected{on(b, {compute, storage_write}, {indirect, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT})};
    EXPECT_EQ(barriers(g), (std::vector<Barriers>{{}, expected}));
}

TEST(plan, write_after_read_waits_only)
{
    SmallGraph g;
    const auto b = g.imported_buffer("b", A::none);
    g.pass("draw", {{b, A::sampled_fragment}});
    g.pass("cull", {{b, A::storage_write}});
    EXPECT_EQ(barriers(g), (std::vector<Barriers>{{}, {on(b, {fragment, 0}, {compute, storage_both})}}));
}

TEST(plan, write_after_write_does_both)
{
    SmallGraph g;
    const auto b = g.imported_buffer("b", A::none);
    g.pass("clear", {{b, A::transfer_write}});
    g.pass("count", {{b, A::storage_write}});
    EXPECT_EQ(barriers(g), (std::vector<Barriers>{
                               {}, {on(b, {transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT}, {compute, storage_both})}}));
}

TEST(plan, write_after_reads_waits_for_all_readers_and_not_for_the_writer)
{
    SmallGraph g;
    const auto b = g.imported_buffer("b", A::none);
    g.pass("w", {{b, A::transfer_write}});
    g.pass("r1", {{b, A::sampled_fragment}});
    g.pass("r2", {{b, A::sampled_compute}});
    g.pass("w2", {{b, A::storage_write, {}, true}});
    const Scope write{transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT};
    EXPECT_EQ(barriers(g), (std::vector<Barriers>{{},
                                                  {on(b, write, {fragment, shader_read})},
                                                  {on(b, write, {compute, shader_read})},
                                                  {on(b, {fragment | compute, 0}, {compute, storage_both})}}));
}

TEST(plan, covered_reader_needs_nothing)
{
    SmallGraph g;
    const auto b = g.imported_buffer("b", A::none);
    g.pass("w", {{b, A::storage_write}});
    g.pass("r", {{b, A::sampled_fragment}});
    g.pass("r again", {{b, A::sampled_fragment}});
    EXPECT_EQ(barriers(g)[2], Barriers{});
}

TEST(plan, read_only_layouts_follow_each_other_like_writes)
{
    SmallGraph g;
    const auto i = g.imported_image("i", A::none);
    g.pass("w", {{i, A::depth_write, {}, true}});
    g.pass("test", {{i, A::depth_read}});
    g.pass("sample", {{i, A::sampled_fragment}});
    g.pass("test again", {{i, A::depth_read}});
    const Scope test{tests | fragment, depth_read | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT}, sample{fragment, shader_read};
    EXPECT_EQ(barriers(g), (std::vector<Barriers>{
                               {on(i, {none, 0}, {tests, depth_read | depth_write}, undefined, depth_layout)},
                               {on(i, {tests, depth_write}, test, depth_layout, depth_read_layout)},
                               {on(i, {tests | fragment, 0}, sample, depth_read_layout, read_layout)},
                               {on(i, {fragment, 0}, test, read_layout, depth_read_layout)},
                           }));
}

TEST(plan, later_reader_continues_from_the_change_of_layout)
{
    SmallGraph g;
    const auto i = g.imported_image("i", A::none);
    g.pass("w", {{i, A::color_write, {}, true}});
    g.pass("r1", {{i, A::sampled_fragment}});
    g.pass("r2", {{i, A::sampled_compute}});
    g.pass("w2", {{i, A::color_write}});
    const Scope target{color, color_both};
    EXPECT_EQ(barriers(g), (std::vector<Barriers>{
                               {on(i, {none, 0}, target, undefined, color_layout)},
                               {on(i, {color, color_write}, {fragment, shader_read}, color_layout, read_layout)},
                               {on(i, {fragment, 0}, {compute, shader_read}, read_layout, read_layout)},
                               // r2 waits for r1's stage, so waiting for r2 is waiting for both
                               {on(i, {compute, 0}, target, read_layout, color_layout)},
                           }));
}

TEST(plan, attachments_load_so_a_second_pass_waits_and_sees)
{
    SmallGraph g;
    const auto d = g.imported_image("d", A::none);
    g.pass("opaque", {{d, A::depth_write, {}, true}});
    g.pass("masked", {{d, A::depth_write}});
    EXPECT_EQ(barriers(g)[1],
              (Barriers{on(d, {tests, depth_write}, {tests, depth_read | depth_write}, depth_layout, depth_layout)}));
}

TEST(plan, discard_forgets_the_layout_and_still_waits)
{
    SmallGraph g;
    const auto i = g.imported_image("i", A::sampled_fragment);
    g.pass("w", {{i, A::color_write, {}, true}});
    g.pass("w2", {{i, A::color_write, {}, true}});
    const Scope target{color, color_both};
    EXPECT_EQ(barriers(g), (std::vector<Barriers>{{on(i, {fragment, 0}, target, undefined, color_layout)},
                                                  {on(i, {color, color_write}, target, undefined, color_layout)}}));
}

TEST(plan, imported_resources_start_from_their_last_use)
{
    SmallGraph g;
    const auto i = g.imported_image("i", A::storage_write);
    const auto b = g.imported_buffer("b", A::vertex_read);
    const auto host = g.imported_buffer("host", A::none);
    g.desc.resources[b].initial_wait = {compute, 0};
    g.pass("p", {{i, A::sampled_fragment}, {b, A::transfer_write}, {host, A::sampled_fragment}});
    EXPECT_EQ(barriers(g), (std::vector<Barriers>{{on(i, {compute, storage_write}, {fragment, shader_read},
                                                      VK_IMAGE_LAYOUT_GENERAL, read_layout),
                                                   on(b, {VK_PIPELINE_STAGE_2_VERTEX_ATTRIBUTE_INPUT_BIT | compute, 0},
                                                      {transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT})}}));
}

TEST(plan, presented_image_continues_from_the_semaphore_and_goes_back)
{
    SmallGraph g;
    const auto i = g.imported_image("swapchain", A::present);
    g.pass("show", {{i, A::color_write, {}, true}});
    EXPECT_EQ(barriers(g, {{i, A::present}}),
              (std::vector<Barriers>{{on(i, {color, 0}, {color, color_both}, undefined, color_layout)},
                                     {on(i, {color, color_write}, {none, 0}, color_layout, present_layout)}}));
}

TEST(plan, final_use_gathers_all_readers)
{
    SmallGraph g;
    const auto b = g.imported_buffer("b", A::none);
    g.pass("w", {{b, A::transfer_write}});
    g.pass("r1", {{b, A::sampled_fragment}});
    g.pass("r2", {{b, A::sampled_compute}});
    EXPECT_EQ(barriers(g, {{b, A::sampled_compute}})[3],
              (Barriers{on(b, {fragment | compute, 0}, {compute, shader_read})}));
    const Plan plan = make_plan(g.desc, std::vector<FinalUse>{{b, A::sampled_compute}});
    EXPECT_EQ(plan.final_access[b], A::sampled_compute);
    EXPECT_EQ(plan.final_waits[b].stages, compute);
    EXPECT_EQ(plan.final_waits[b].access, 0u);
}

TEST(plan, final_use_already_met_needs_nothing)
{
    SmallGraph g;
    const auto b = g.imported_buffer("b", A::none);
    g.pass("w", {{b, A::transfer_write}});
    g.pass("r", {{b, A::sampled_compute}});
    EXPECT_EQ(barriers(g, {{b, A::sampled_compute}})[2], Barriers{});
}

TEST(plan, without_final_use_the_next_frame_learns_what_to_wait_for)
{
    SmallGraph g;
    const auto b = g.imported_buffer("b", A::none);
    const auto idle = g.imported_image("idle", A::sampled_vertex);
    g.pass("w", {{b, A::transfer_write}});
    g.pass("r1", {{b, A::sampled_fragment}});
    g.pass("r2", {{b, A::sampled_compute}});
    const Plan plan = make_plan(g.desc);
    EXPECT_EQ(plan.final_access, (std::vector<Access>{A::sampled_compute, A::sampled_vertex}));
    EXPECT_EQ(plan.final_waits[b].stages, fragment | compute);
    EXPECT_EQ(plan.final_waits[idle].stages, VK_PIPELINE_STAGE_2_PRE_RASTERIZATION_SHADERS_BIT);
}

TEST(plan, mips_are_followed_one_by_one_and_equal_neighbours_joined)
{
    SmallGraph g;
    const auto i = g.add({.name = "chain", .mips = 4, .layers = 2, .transient = false, .keep = true});
    g.pass("mip 0", {{i, A::color_write, {0, 1, 0, 2}, true}});
    g.pass("mip 1", {{i, A::sampled_fragment, {0, 1, 0, 2}}, {i, A::color_write, {1, 1, 0, 2}, true}});
    g.pass("use", {{i, A::sampled_fragment, {0, 2, 0, 2}}});
    const auto part = [&](SubresourceRange range, Scope s, Scope d, VkImageLayout before, VkImageLayout after) {
        Barrier b = on(i, s, d, before, after);
        b.range = range;
        return b;
    };
    const Scope target{color, color_both}, written{color, color_write}, read{fragment, shader_read};
    EXPECT_EQ(barriers(g), (std::vector<Barriers>{
                               {part({0, 1, 0, 2}, {}, target, undefined, color_layout)},
                               {part({0, 1, 0, 2}, written, read, color_layout, read_layout),
                                part({1, 1, 0, 2}, {}, target, undefined, color_layout)},
                               {part({1, 1, 0, 2}, written, read, color_layout, read_layout)},
                           }));
}

TEST(plan, barriers_that_form_no_rectangle_are_split)
{
    SmallGraph g;
    const auto i = g.add({.name = "i", .mips = 2, .layers = 2, .transient = false, .keep = true});
    g.pass("corner", {{i, A::storage_write, {0, 1, 0, 1}, true}});
    g.pass("all", {{i, A::storage_write, {0, 2, 0, 2}}});
    const Barriers all = barriers(g)[1];
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].range, (SubresourceRange{0, 1, 0, 1}));
    EXPECT_EQ(all[1].range, (SubresourceRange{1, 1, 0, 2}));
    EXPECT_EQ(all[2].range, (SubresourceRange{0, 1, 1, 1}));
}

TEST(plan, depth_test_covers_sampling_in_the_same_pass)
{
    for (const bool sampled_first : {false, true}) {
        SmallGraph g;
        const auto d = g.imported_image("d", A::depth_write);
        if (sampled_first)
            g.pass("p", {{d, A::sampled_fragment}, {d, A::depth_read}});
        else
            g.pass("p", {{d, A::depth_read}, {d, A::sampled_fragment}});
        EXPECT_EQ(barriers(g)[0], (Barriers{on(d, {tests, depth_write}, {tests | fragment, depth_read | shader_read},
                                               depth_layout, depth_read_layout)}));
        EXPECT_EQ(make_plan(g.desc).final_access[d], A::depth_read);
    }
}

TEST(plan, two_uses_of_a_buffer_are_one)
{
    SmallGraph g;
    const auto b = g.imported_buffer("b", A::none);
    g.pass("w", {{b, A::transfer_write}});
    g.pass("p", {{b, A::storage_write, {}, true}, {b, A::indirect_read}});
    g.pass("r", {{b, A::vertex_read}});
    EXPECT_EQ(barriers(g),
              (std::vector<Barriers>{
                  {},
                  {on(b, {transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                      {compute | indirect, storage_both | VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT})},
                  {on(b, {compute | indirect, storage_write},
                      {VK_PIPELINE_STAGE_2_VERTEX_ATTRIBUTE_INPUT_BIT, VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT})}}));
    g.desc.passes.pop_back();
    std::swap(g.desc.passes[1].uses[0], g.desc.passes[1].uses[1]); // the write counts, wherever it stands
    EXPECT_EQ(make_plan(g.desc).final_access[b], A::storage_write);
}

} // namespace
} // namespace atrium::graph
