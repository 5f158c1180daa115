// The judge judged: sound plans spoiled in one place each, which it has to notice and call by name.

#include "tests/graph/random_graph.hpp"
#include "tests/graph/small_graph.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace atrium::graph {
namespace {

using A = Access;

/// Two images that share memory, a buffer, an import: every rule has a barrier here.
oracle::Frame sound_frame()
{
    SmallGraph g;
    const auto first = g.image("first", 100), second = g.image("second", 100), third = g.image("third", 100);
    const auto commands = g.imported_buffer("commands", A::none);
    g.pass("make first", {{first, A::color_write, {}, true}, {commands, A::storage_write}});
    g.pass("read first",
           {{first, A::sampled_fragment}, {second, A::color_write, {}, true}, {commands, A::indirect_read}});
    g.pass("read first again",
           {{first, A::sampled_compute}, {second, A::color_write}, {commands, A::sampled_fragment}});
    g.pass("make third",
           {{third, A::color_write, {}, true}, {second, A::sampled_fragment}, {commands, A::storage_write}});
    oracle::Frame frame{g.desc, {{commands, A::host_read}}, {}};
    frame.plan = make_plan(frame.graph, frame.finals);
    return frame;
}

std::string problem_after(const std::function<void(Plan&)>& spoil)
{
    oracle::Frame frame = sound_frame();
    spoil(frame.plan);
    return oracle::Oracle({frame}).problem();
}

/// The barrier on a resource before a planned pass.
Barrier& find(Plan& plan, std::size_t pass, ResourceIndex resource)
{
    for (Barrier& b : plan.passes[pass].barriers) {
        if (b.resource == resource) return b;
    }
    throw std::logic_error("no such barrier");
}

TEST(oracle, accepts_the_sound_frame)
{
    EXPECT_EQ(problem_after([](Plan&) {}), "");
}

TEST(oracle, sees_each_rule_broken)
{
    const auto expect = [](const char* words, const std::function<void(Plan&)>& spoil) {
        const std::string problem = problem_after(spoil);
        EXPECT_NE(problem.find(words), std::string::npos) << "wanted: " << words << "\ngot: " << problem;
    };
    constexpr ResourceIndex first = 0, third = 2, commands = 3;
    // read after write
    expect("not visible", [&](Plan& p) { find(p, 1, commands).src_access = 0; });
    expect("not visible", [&](Plan& p) { find(p, 1, commands).dst_access = 0; });
    expect("not ordered", [&](Plan& p) { find(p, 1, commands).src_stages = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT; });
    expect("not ordered", [&](Plan& p) { find(p, 1, commands).dst_stages = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT; });
    // write after read: both readers are waited for
    expect("not ordered", [&](Plan& p) { find(p, 3, commands).src_stages &= ~VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT; });
    expect("not ordered",
           [&](Plan& p) { find(p, 3, commands).src_stages &= ~VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT; });
    // a reader continues from the change of layout, not from the write before it
    expect("not ordered", [&](Plan& p) {
        find(p, 2, first).src_stages = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
        find(p, 2, first).src_access = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    });
    // layouts
    expect("not available to the change", [&](Plan& p) { find(p, 1, first).src_access = 0; });
    expect("not ordered before the change", [&](Plan& p) { find(p, 1, first).src_stages = VK_PIPELINE_STAGE_2_NONE; });
    expect("wrong old layout", [&](Plan& p) { find(p, 1, first).old_layout = VK_IMAGE_LAYOUT_GENERAL; });
    expect("wrong layout for the use", [&](Plan& p) { find(p, 1, first).new_layout = VK_IMAGE_LAYOUT_GENERAL; });
    expect("contents lost", [&](Plan& p) { find(p, 1, first).old_layout = VK_IMAGE_LAYOUT_UNDEFINED; });
    // memory
    expect("not ordered before the change",
           [&](Plan& p) { find(p, 3, third).src_stages = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT; });
    // final use
    expect("(final)", [&](Plan& p) { p.final_barriers.clear(); });
    // twice the same
    expect("two barriers at once", [&](Plan& p) { p.passes[1].barriers.push_back(find(p, 1, commands)); });
}

TEST(oracle, sees_that_an_occupant_forgets_to_make_available)
{
    SmallGraph g;
    const auto a = g.image("a", 100), b = g.image("b", 100);
    g.pass("a", {{a, A::color_write, {}, true}});
    g.pass("b", {{b, A::color_write, {}, true}});
    oracle::Frame frame{g.desc, {}, make_plan(g.desc)};
    EXPECT_EQ(oracle::Oracle({frame}).problem(), "");
    frame.plan.passes[1].barriers[0].takes_memory = false;
    EXPECT_NE(oracle::Oracle({frame}).problem().find("not available"), std::string::npos);
}

TEST(oracle, sees_wrong_placements)
{
    EXPECT_EQ(oracle::placement_problem(sound_frame()), "");
    const auto spoilt = [](const std::function<void(Plan&)>& spoil) {
        oracle::Frame frame = sound_frame();
        spoil(frame.plan);
        return oracle::placement_problem(frame);
    };
    EXPECT_EQ(spoilt([](Plan& p) { p.placements[1] = p.placements[0]; }),
              "second and first have the same memory at the same time");
    EXPECT_EQ(spoilt([](Plan& p) { p.placements[0].offset = 1; }), "first sticks out of its block");
    EXPECT_EQ(spoilt([](Plan& p) { p.block_class[0] = 1; }), "first is in a block of another class");
    EXPECT_NE(spoilt([](Plan& p) { p.placements[3] = p.placements[0]; }), "");
}

TEST(oracle, sees_attachments_wrongly_stored_or_not)
{
    oracle::Frame frame = sound_frame();
    EXPECT_EQ(oracle::contents_problem(frame), "");
    frame.plan.passes[1].unstored = 2; // second, which is read
    EXPECT_EQ(oracle::contents_problem(frame), "other attachments of read first are stored than should be");
    frame = sound_frame();
    EXPECT_NE(frame.plan.passes[3].unstored, 0u) << "nobody reads third";
    frame.plan.passes[3].unstored = 0;
    EXPECT_NE(oracle::contents_problem(frame), "");
}

/// Two frames of an image with a history: the second reads what the first wrote, and writes where it read before.
std::vector<oracle::Frame> frames_with_history()
{
    SmallGraph g;
    const auto now = g.add({.name = "now", .transient = false, .keep = true, .initial_parts = {{}}});
    const auto before = g.add({.name = "before", .transient = false, .initial_parts = {{}}});
    g.pass("write", {{now, A::color_write, {}, true}});
    oracle::Frame first{g.desc, {}, {}, {}, {{now, before}}, g.desc.passes};
    first.passes_with_history[0].uses.push_back({before, A::sampled_fragment});
    first.plan = make_plan(first.graph);
    oracle::Frame second = next_frame(first);
    second.plan = make_plan(second.graph);
    return {first, second};
}

TEST(oracle, follows_memory_that_swaps)
{
    const std::vector<oracle::Frame> sound = frames_with_history();
    EXPECT_EQ(sound[1].memory_of, (std::vector<ResourceIndex>{1, 0}));
    EXPECT_EQ(oracle::Oracle(sound).problem(), "");
    EXPECT_EQ(oracle::contents_problem(sound[1]), "");
    ASSERT_EQ(sound[1].plan.passes[0].barriers.size(), 2u);
    EXPECT_NE(oracle::Oracle(sound).problem_without({1, 0, 1}), "") << "the barrier on what the first frame wrote";

    std::vector<oracle::Frame> spoilt = sound;
    spoilt[1].memory_of = {0, 1};
    EXPECT_NE(oracle::Oracle(spoilt).problem(), "") << "nothing was written there";
    spoilt = sound;
    spoilt[1].graph.resources[1].initial_parts[0].last = A::storage_write;
    spoilt[1].plan = make_plan(spoilt[1].graph);
    EXPECT_NE(oracle::Oracle(spoilt).problem().find("wrong old layout"), std::string::npos);
    spoilt = sound;
    spoilt[0].plan.final_parts[0][0].defined = false;
    EXPECT_NE(oracle::contents_problem(spoilt[0]), "");
}

TEST(oracle, sees_wrong_choices_of_passes)
{
    oracle::Frame frame = sound_frame();
    EXPECT_EQ(oracle::passes_problem(frame), "");
    frame.plan.passes.pop_back();
    EXPECT_NE(oracle::passes_problem(frame), "");
}

} // namespace
} // namespace atrium::graph
