// The plan as text and as a picture.

#include "tests/graph/small_graph.hpp"

#include <gtest/gtest.h>

namespace atrium::graph {
namespace {

using A = Access;

SmallGraph frame()
{
    SmallGraph g;
    const auto commands = g.buffer("commands");
    const auto depth = g.image("depth", 4096), albedo = g.image("albedo", 4096);
    const auto bloom = g.add({.name = "bloom", .mips = 2, .size = 2048, .alignment = 256});
    const auto probe = g.image("probe", 100);
    const auto screen = g.imported_image("screen", A::present);
    g.pass("cull", {{commands, A::storage_write, {}, true}});
    g.pass_if_wanted(
        "gbuffer",
        {{commands, A::indirect_read}, {depth, A::depth_write, {}, true}, {albedo, A::color_write, {}, true}});
    g.pass_if_wanted("probe", {{depth, A::sampled_compute}, {probe, A::storage_write, {}, true}});
    g.pass_if_wanted("lighting",
                     {{depth, A::sampled_fragment}, {albedo, A::sampled_fragment}, {screen, A::color_write, {}, true}});
    g.pass_if_wanted("bloom", {{screen, A::sampled_fragment}, {bloom, A::color_write, {0, 1, 0, 1}, true}});
    g.pass_if_wanted("add", {{bloom, A::sampled_fragment, {0, 1, 0, 1}}, {screen, A::color_write}});
    return g;
}

constexpr const char* frame_text = R"(pass cull, always
    barrier commands: indirect (none) -> compute (sampled_read|storage_read|storage_write)
    writes commands: storage_write, discards
pass gbuffer
    barrier commands: compute (storage_write) -> indirect (indirect_read)
    barrier depth: fragment (none) -> early_depth|late_depth (depth_read|depth_write), undefined -> depth, takes memory
    barrier albedo: fragment (none) -> color (color_read|color_write), undefined -> color
    reads commands: indirect_read
    writes depth: depth_write, discards
    writes albedo: color_write, discards
pass lighting
    barrier depth: early_depth|late_depth (depth_write) -> fragment (sampled_read|storage_read), depth -> shader_read_only
    barrier albedo: color (color_write) -> fragment (sampled_read|storage_read), color -> shader_read_only
    barrier screen: color (none) -> color (color_read|color_write), undefined -> color
    reads depth: sampled_fragment
    reads albedo: sampled_fragment
    writes screen: color_write, discards
pass bloom
    barrier screen: color (color_write) -> fragment (sampled_read|storage_read), color -> shader_read_only
    barrier bloom[mip 0, layer 0]: fragment (none) -> color (color_read|color_write), undefined -> color, takes memory
    reads screen: sampled_fragment
    writes bloom[mip 0, layer 0]: color_write, discards
pass add
    barrier bloom[mip 0, layer 0]: color (color_write) -> fragment (sampled_read|storage_read), color -> shader_read_only
    barrier screen: fragment (none) -> color (color_read|color_write), shader_read_only -> color
    reads bloom[mip 0, layer 0]: sampled_fragment
    writes screen: color_write
end of frame
    barrier screen: color (color_write) -> none (none), color -> present
dropped
    probe
memory
    block 0: 4096 bytes, aligned to 256, class 0
        at 0: depth, 4096 bytes, gbuffer .. lighting
        at 0: bloom, 2048 bytes, bloom .. add
    block 1: 4096 bytes, aligned to 1, class 0
        at 0: albedo, 4096 bytes, gbuffer .. lighting
    8192 bytes for 10240 wanted: 2048 saved
)";

TEST(plan_text, tells_the_whole_frame)
{
    const SmallGraph g = frame();
    const Plan plan = make_plan(g.desc, std::vector<FinalUse>{{5, A::present}});
    EXPECT_EQ(to_text(g.desc, plan), frame_text);
}

TEST(plan_text, bits_without_a_name_show_as_numbers)
{
    const SmallGraph g = frame();
    Plan plan = make_plan(g.desc, std::vector<FinalUse>{{5, A::present}});
    plan.passes[0].barriers[0].src_stages = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | (1ull << 60);
    EXPECT_NE(to_text(g.desc, plan).find("compute|0x1000000000000000 (none)"), std::string::npos);
}

TEST(plan_dot, draws_passes_resources_uses_and_blocks)
{
    const SmallGraph g = frame();
    const std::string dot = to_dot(g.desc, make_plan(g.desc, std::vector<FinalUse>{{5, A::present}}));
    const auto has = [&](const char* part) { EXPECT_NE(dot.find(part), std::string::npos) << part << "\n" << dot; };
    has("digraph frame {");
    has("    p0 [shape=box, style=filled, label=\"cull\"];\n");
    has("    p2 [shape=box, style=dashed, label=\"probe\"];\n");
    has("    p1 -> r1 [label=\"depth_write\"];\n");
    has("    r0 -> p1 [label=\"indirect_read\"];\n");
    has("    r1 -> p2 [label=\"sampled_compute\", style=dashed];\n");
    has("    subgraph cluster_block0 {\n        label=\"block 0, 4096 bytes\";\n        r1 [shape=ellipse, "
        "style=solid, label=\"depth\"];\n");
    has("    r5 [shape=ellipse, style=bold, label=\"screen\"];\n");
}

TEST(plan_dot, names_are_escaped)
{
    SmallGraph g;
    const auto i = g.imported_image("a \"b\"\\\nc", A::none);
    g.pass("p", {{i, A::color_write, {}, true}});
    EXPECT_NE(to_dot(g.desc, make_plan(g.desc)).find(R"(label="a \"b\"\\\nc")"), std::string::npos);
}

} // namespace
} // namespace atrium::graph
