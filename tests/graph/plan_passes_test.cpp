// Which passes run, and which graphs are refused.

#include "tests/graph/small_graph.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace atrium::graph {
namespace {

using Indices = std::vector<std::uint32_t>;

TEST(plan_passes, unused_passes_are_dropped_with_all_that_only_they_used)
{
    SmallGraph g;
    const auto a = g.image("a"), b = g.image("b"), c = g.image("c");
    const auto out = g.imported_image("out", A::none);
    g.pass_if_wanted("a", {{a, A::color_write, {}, true}});
    g.pass_if_wanted("b from a", {{a, A::sampled_fragment}, {b, A::color_write, {}, true}});
    g.pass_if_wanted("c", {{c, A::color_write, {}, true}});
    g.pass_if_wanted("out from c", {{c, A::sampled_fragment}, {out, A::color_write, {}, true}});
    EXPECT_EQ(make_plan(g.desc).dropped, (Indices{0, 1}));
    g.desc.resources[b].keep = true;
    EXPECT_EQ(make_plan(g.desc).dropped, Indices{});
    g.desc.resources[b].keep = false;
    g.desc.passes[1].side_effect = true;
    EXPECT_EQ(make_plan(g.desc).dropped, Indices{});
}

TEST(plan_passes, what_a_later_pass_overwrites_is_not_wanted)
{
    SmallGraph g;
    const auto out = g.imported_image("out", A::none);
    g.pass_if_wanted("first", {{out, A::color_write, {}, true}});
    g.pass_if_wanted("second", {{out, A::color_write, {}, true}});
    g.pass_if_wanted("blended", {{out, A::color_write}});
    EXPECT_EQ(make_plan(g.desc).dropped, Indices{0});
}

TEST(plan_passes, copies_into_a_part_leave_the_rest_wanted)
{
    SmallGraph g;
    const auto out = g.imported_buffer("out", A::none);
    g.pass_if_wanted("fill", {{out, A::transfer_write, {}, true}});
    g.pass_if_wanted("patch", {{out, A::transfer_write}});
    EXPECT_EQ(make_plan(g.desc).dropped, Indices{});
}

TEST(plan_passes, imports_are_wanted_only_when_kept_or_given_a_final_use)
{
    SmallGraph g;
    const auto out = g.imported_image("out", A::none);
    g.desc.resources[out].keep = false;
    g.pass_if_wanted("p", {{out, A::color_write, {}, true}});
    EXPECT_EQ(make_plan(g.desc).dropped, Indices{0});
    EXPECT_EQ(make_plan(g.desc, std::vector<FinalUse>{{out, A::present}}).dropped, Indices{});
}

TEST(plan_passes, each_mip_is_wanted_for_itself)
{
    SmallGraph g;
    const auto i = g.add({.name = "i", .mips = 2});
    const auto out = g.imported_image("out", A::none);
    g.pass_if_wanted("mip 0", {{i, A::color_write, {0, 1, 0, 1}, true}});
    g.pass_if_wanted("mip 1", {{i, A::color_write, {1, 1, 0, 1}, true}});
    g.pass_if_wanted("out", {{i, A::sampled_fragment, {1, 1, 0, 1}}, {out, A::color_write, {}, true}});
    EXPECT_EQ(make_plan(g.desc).dropped, Indices{0});
}

TEST(plan_refusals, reading_what_nobody_wrote_names_both)
{
    SmallGraph g;
    const auto ao = g.image("ao");
    g.pass("lighting", {{ao, A::sampled_fragment}});
    g.pass("ao", {{ao, A::color_write, {}, true}});
    EXPECT_EQ(refusal(g), "graph: pass \"lighting\" reads \"ao\", which no earlier pass wrote");
    std::swap(g.desc.passes[0], g.desc.passes[1]);
    EXPECT_EQ(refusal(g), "");
}

TEST(plan_refusals, reading_a_mip_that_nobody_wrote_names_it)
{
    SmallGraph g;
    const auto i = g.add({.name = "bloom", .mips = 3, .layers = 2});
    g.pass("down", {{i, A::color_write, {0, 2, 0, 2}, true}});
    g.pass("up", {{i, A::sampled_fragment, {0, 3, 0, 2}}});
    EXPECT_EQ(refusal(g), "graph: pass \"up\" reads \"bloom\" (mip 2, layer 0), which no earlier pass wrote");
    EXPECT_EQ(refusal({}, {}), "");
}

TEST(plan_refusals, final_use_of_what_nobody_wrote)
{
    SmallGraph g;
    const auto i = g.image("i");
    EXPECT_EQ(refusal(g, {{i, A::host_read}}), "graph: the end of the frame reads \"i\", which no earlier pass wrote");
}

TEST(plan_refusals, two_layouts_at_once_name_both)
{
    SmallGraph g;
    const auto i = g.imported_image("color", A::none);
    g.pass("feedback", {{i, A::color_write}, {i, A::sampled_fragment}});
    EXPECT_EQ(refusal(g),
              "graph: pass \"feedback\" uses \"color\" as color_write and as sampled_fragment, which need two layouts");
}

TEST(plan_refusals, depth_test_covers_sampling_in_fragment_shaders_only)
{
    for (const std::vector<Access>& order : {std::vector{A::depth_read, A::sampled_compute},
                                             {A::depth_read, A::sampled_fragment, A::sampled_vertex},
                                             {A::sampled_fragment, A::sampled_vertex, A::depth_read},
                                             {A::sampled_vertex, A::sampled_fragment, A::depth_read}}) {
        SmallGraph g;
        const auto d = g.imported_image("d", A::depth_write);
        std::vector<Use> uses;
        for (const Access a : order) uses.push_back({d, a});
        g.pass("p", uses);
        EXPECT_NE(refusal(g), "");
    }
}

TEST(plan_refusals, uses_that_make_no_sense)
{
    const auto refuses = [](const Use& use, const char* part) {
        SmallGraph g;
        g.add({.name = "image", .mips = 2, .layers = 3, .transient = false});
        g.imported_buffer("buffer", A::none);
        g.pass("pass", {use});
        EXPECT_NE(refusal(g).find(part), std::string::npos) << refusal(g);
    };
    refuses({7, A::color_write}, "pass \"pass\" uses resource 7, and there are 2");
    refuses({0, A::none}, "\"image\" without saying how");
    refuses({0, A::count}, "\"image\" without saying how");
    refuses({0, A::index_read}, "\"image\" as index_read, which an image cannot be");
    refuses({1, A::color_write}, "\"buffer\" as color_write, which a buffer cannot be");
    refuses({1, A::indirect_read, {}, true}, "discards what it reads");
    refuses({0, A::color_write, {0, 3, 0, 1}}, "outside its 2 mips and 3 layers");
    refuses({0, A::color_write, {1, 1, 2, 2}}, "outside");
    refuses({0, A::color_write, {0, 0, 0, 1}}, "outside");
    refuses({0, A::color_write, {1, ~0u, 0, 1}}, "outside");
}

TEST(plan_refusals, resources_that_make_no_sense)
{
    const auto refuses = [](const ResourceDesc& resource) {
        SmallGraph g;
        g.add(resource);
        EXPECT_NE(refusal(g).find("\"odd\""), std::string::npos) << refusal(g);
    };
    refuses({.name = "odd", .mips = 0});
    refuses({.name = "odd", .alignment = 3});
    refuses({.name = "odd", .alignment = 0});
    refuses({.name = "odd", .size = ~std::uint64_t{0}});
    refuses({.name = "odd", .transient = false, .initial = A::index_read});
    refuses({.name = "odd", .is_image = false, .transient = false, .initial = A::present});
}

TEST(plan_refusals, two_final_uses_of_one_resource)
{
    SmallGraph g;
    const auto i = g.imported_image("i", A::color_write);
    EXPECT_NE(refusal(g, {{i, A::present}, {i, A::present}}), "");
    EXPECT_EQ(refusal(g, {{i, A::present}}), "");
}

} // namespace
} // namespace atrium::graph
