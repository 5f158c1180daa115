// Storage images, mips, samples, attachments that are not stored, and state passed from frame to frame.

#include "tests/graph/small_graph.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace atrium::graph {
namespace {

constexpr auto build = VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR;
constexpr auto general = VK_IMAGE_LAYOUT_GENERAL;

void expect(const Barrier& b, Scope source, Scope destination, VkImageLayout before = undefined,
            VkImageLayout after = undefined)
{
    EXPECT_EQ(b.src_stages, source.stages);
    EXPECT_EQ(b.src_access, source.access);
    EXPECT_EQ(b.dst_stages, destination.stages);
    EXPECT_EQ(b.dst_access, destination.access);
    EXPECT_EQ(b.old_layout, before);
    EXPECT_EQ(b.new_layout, after);
}

TEST(plan_images, a_storage_image_is_written_in_one_layout_and_sampled_in_another)
{
    SmallGraph g;
    const auto i = g.image("i");
    g.pass("write", {{i, A::storage_write, {}, true}});
    g.pass("read and write", {{i, A::storage_write}});
    g.pass("only read", {{i, A::storage_read}});
    g.pass("sample", {{i, A::sampled_fragment}});
    const Plan plan = make_plan(g.desc);
    const VkAccessFlags2 written = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    expect(plan.passes[0].barriers.at(0), {fragment, 0}, {compute, storage_both}, undefined, general);
    expect(plan.passes[1].barriers.at(0), {compute, written}, {compute, storage_both}, general, general);
    expect(plan.passes[2].barriers.at(0), {compute, written}, {compute, VK_ACCESS_2_SHADER_STORAGE_READ_BIT}, general,
           general);
    expect(plan.passes[3].barriers.at(0), {compute, 0}, {fragment, shader_read}, general, read_layout);
}

TEST(plan_images, each_mip_of_a_chain_waits_for_the_one_before)
{
    SmallGraph g;
    const auto i = g.add({.name = "i", .mips = 3});
    g.pass("0", {{i, A::color_write, {0, 1, 0, 1}, true}});
    g.pass("1", {{i, A::sampled_fragment, {0, 1, 0, 1}}, {i, A::color_write, {1, 1, 0, 1}, true}});
    g.pass("2", {{i, A::sampled_fragment, {1, 1, 0, 1}}, {i, A::color_write, {2, 1, 0, 1}, true}});
    g.pass("all", {{i, A::sampled_fragment, {0, 3, 0, 1}}});
    const Plan plan = make_plan(g.desc);
    ASSERT_EQ(plan.passes[2].barriers.size(), 2u);
    EXPECT_EQ(plan.passes[2].barriers[0].range, (SubresourceRange{1, 1, 0, 1}));
    EXPECT_EQ(plan.passes[2].barriers[0].new_layout, read_layout);
    EXPECT_EQ(plan.passes[2].barriers[1].range, (SubresourceRange{2, 1, 0, 1}));
    ASSERT_EQ(plan.passes[3].barriers.size(), 1u) << "only the last mip is not readable yet";
    EXPECT_EQ(plan.passes[3].barriers[0].range, (SubresourceRange{2, 1, 0, 1}));
}

TEST(plan_images, samples_are_resolved_and_not_stored)
{
    SmallGraph g;
    const auto samples = g.add({.name = "samples", .samples = 4}), mean = g.image("mean");
    g.pass("draw", {{samples, A::color_write, {}, true}, {mean, A::resolve_write, {}, true}});
    g.pass("read", {{mean, A::sampled_fragment}});
    const Plan plan = make_plan(g.desc);
    EXPECT_EQ(plan.passes[0].unstored, 1u);
    expect(plan.passes[1].barriers.at(0), {color, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT}, {fragment, shader_read},
           VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, read_layout);
    EXPECT_NE(to_text(g.desc, plan).find("writes samples: color_write, discards, not stored\n"), std::string::npos);
    g.pass("read samples too", {{samples, A::sampled_fragment}});
    EXPECT_EQ(make_plan(g.desc).passes[0].unstored, 0u);
}

TEST(plan_images, attachments_are_stored_only_for_passes_that_run)
{
    SmallGraph g;
    const auto a = g.image("a"), b = g.image("b"), c = g.image("c"), d = g.image("d"), kept = g.image("kept");
    g.desc.resources[kept].keep = true;
    g.pass("draw", {{a, A::color_write, {}, true},
                    {b, A::color_write, {}, true},
                    {kept, A::color_write, {}, true},
                    {d, A::depth_write, {}, true}});
    g.pass_if_wanted("dropped", {{a, A::sampled_fragment}, {c, A::color_write, {}, true}});
    g.pass("read", {{b, A::sampled_fragment}, {d, A::depth_read}});
    g.pass("draw over", {{b, A::color_write, {}, true}});
    const Plan plan = make_plan(g.desc);
    EXPECT_EQ(plan.passes[0].unstored, 1u) << "only a is read by nobody that runs";
    EXPECT_EQ(plan.passes[2].unstored, 1u);
}

TEST(plan_images, accesses_without_a_binding_have_their_own_scopes)
{
    SmallGraph g;
    const auto vertices = g.buffer("vertices"), tree = g.buffer("tree");
    g.pass("deform", {{vertices, A::address_write, {}, true}});
    g.pass("build", {{vertices, A::acceleration_input}, {tree, A::acceleration_build, {}, true}});
    g.pass("trace", {{tree, A::acceleration_fragment}, {vertices, A::address_fragment}});
    const Plan plan = make_plan(g.desc);
    const VkAccessFlags2 tree_read = VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR;
    expect(plan.passes[1].barriers.at(0), {compute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
           {build, VK_ACCESS_2_SHADER_READ_BIT | tree_read});
    expect(plan.passes[2].barriers.at(0), {build, VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR},
           {fragment, tree_read});
    expect(plan.passes[2].barriers.at(1), {compute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
           {fragment, VK_ACCESS_2_SHADER_STORAGE_READ_BIT});
}

TEST(plan_images, what_makes_no_sense_is_refused)
{
    const auto refuses = [](const ResourceDesc& resource, Access access, const char* part) {
        SmallGraph g;
        const auto r = g.add(resource);
        g.pass("pass", {{r, access, {}, true}});
        EXPECT_NE(refusal(g).find(part), std::string::npos) << refusal(g);
    };
    const ResourceDesc samples{.name = "odd", .samples = 4};
    refuses(samples, A::storage_write, "\"odd\" as storage_write, which an image with 4 samples cannot be");
    refuses(samples, A::resolve_write, "as resolve_write, which an image with 4 samples cannot be");
    refuses(samples, A::transfer_write, "as transfer_write");
    refuses({.name = "odd", .mips = 2, .samples = 4}, A::color_write, "several samples and several mips");
    refuses({.name = "odd", .samples = 3}, A::color_write, "not a power of two");
    refuses({.name = "odd", .initial_parts = {{}}}, A::color_write, "transient and has a state from before");
    refuses({.name = "odd", .mips = 2, .transient = false, .initial_parts = {{}}}, A::color_write,
            "one state for each");
    refuses({.name = "odd", .is_image = false}, A::resolve_write, "which a buffer cannot be");
    refuses({.name = "odd"}, A::address_write, "which an image cannot be");
}

/// A persistent image with two mips.
ResourceIndex persistent(SmallGraph& g, std::vector<PartState> parts)
{
    return g.add({.name = "kept", .mips = 2, .transient = false, .keep = true, .initial_parts = std::move(parts)});
}

TEST(plan_persistent, parts_are_handed_on_one_by_one)
{
    SmallGraph g;
    const auto i = persistent(g, {{}, {}});
    g.pass_if_wanted("write mip 1", {{i, A::color_write, {1, 1, 0, 1}, true}});
    g.pass("read it", {{i, A::sampled_fragment, {1, 1, 0, 1}}});
    const std::vector<PartState> parts = make_plan(g.desc).final_parts[i];
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].last, A::none);
    EXPECT_FALSE(parts[0].defined);
    EXPECT_EQ(parts[1].last, A::sampled_fragment);
    EXPECT_TRUE(parts[1].defined);

    SmallGraph next;
    persistent(next, parts);
    next.pass("write all", {{i, A::color_write, {0, 1, 0, 1}, true}, {i, A::color_write, {1, 1, 0, 1}}});
    const Plan plan = make_plan(next.desc);
    ASSERT_EQ(plan.passes[0].barriers.size(), 2u);
    EXPECT_EQ(plan.passes[0].barriers[0].old_layout, undefined);
    EXPECT_EQ(plan.passes[0].barriers[1].old_layout, read_layout);
    EXPECT_EQ(plan.passes[0].barriers[1].src_stages, VkPipelineStageFlags2{fragment});
    EXPECT_EQ(plan.final_parts[i][0].last, A::color_write);
}

TEST(plan_persistent, parts_that_hold_nothing_must_be_written_first)
{
    SmallGraph g;
    const auto i = persistent(g, {{A::sampled_fragment, {}, true}, {A::sampled_fragment, {}, false}});
    g.pass("read", {{i, A::sampled_fragment, {0, 1, 0, 1}}});
    EXPECT_EQ(refusal(g), "");
    g.pass("read too much", {{i, A::sampled_fragment, {0, 2, 0, 1}}});
    EXPECT_EQ(refusal(g), "graph: pass \"read too much\" reads \"kept\" (mip 1, layer 0), which no earlier pass wrote");
}

TEST(plan_persistent, what_a_frame_does_not_use_stays_as_it_was)
{
    SmallGraph g;
    const PartState before{A::sampled_compute, {fragment | compute, 0}, true};
    const auto i = persistent(g, {before, before});
    g.pass("idle", {});
    const PartState after = make_plan(g.desc).final_parts[i][1];
    EXPECT_EQ(after.last, before.last);
    EXPECT_EQ(after.wait.stages, before.wait.stages);
    EXPECT_EQ(after.wait.access, 0u);
    EXPECT_TRUE(after.defined);
}

} // namespace
} // namespace atrium::graph
