// The drawn graph: which boxes and lines a frame has, and where they stand.

#include "app/gui/graph_boxes.hpp"
#include "app/gui/graph_layout.hpp"
#include "tests/gui/graph_of_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace atrium::gui {
namespace {

constexpr vec2 gaps{40, 10};

struct RandomGraph {
    explicit RandomGraph(unsigned seed)
    {
        std::mt19937 random(seed);
        std::uniform_int_distribution<std::size_t> boxes(1, 80), ways(0, 5);
        std::uniform_real_distribution<float> side(10, 200);
        sizes.resize(boxes(random));
        for (vec2& size : sizes) size = {side(random), side(random)};
        for (std::size_t to = 1; to < sizes.size(); ++to) {
            std::uniform_int_distribution<std::size_t> before(0, to - 1);
            for (std::size_t n = ways(random); n > 0; --n) edges.push_back({before(random), to});
        }
    }
    std::vector<vec2> sizes;
    std::vector<GraphEdge> edges;
};

/// How often two lines between the boxes' middles cross.
std::size_t crossings(const std::vector<vec2>& corners, const RandomGraph& graph)
{
    const auto middle = [&](std::size_t box) { return corners[box] + 0.5f * graph.sizes[box]; };
    const auto side = [](const vec2& a, const vec2& b, const vec2& p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0;
    };
    std::size_t count = 0;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const vec2 a = middle(graph.edges[i].from), b = middle(graph.edges[i].to);
            const vec2 c = middle(graph.edges[j].from), d = middle(graph.edges[j].to);
            count += side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
        }
    }
    return count;
}

TEST(graph_layout, no_boxes_overlap_and_every_edge_goes_to_the_right)
{
    std::size_t edges = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const RandomGraph graph(seed);
        const std::vector<vec2> at = lay_out_graph(graph.sizes, graph.edges, gaps);
        ASSERT_EQ(at.size(), graph.sizes.size());
        edges += graph.edges.size();
        for (std::size_t i = 0; i < at.size(); ++i) {
            EXPECT_GE(at[i].x, 0);
            EXPECT_GE(at[i].y, 0);
            for (std::size_t j = 0; j < i; ++j) {
                const vec2 low = glm::max(at[i], at[j]);
                const vec2 high = glm::min(at[i] + graph.sizes[i], at[j] + graph.sizes[j]);
                EXPECT_FALSE(low.x < high.x && low.y < high.y + gaps.y - 0.1f) << seed << ": " << i << ", " << j;
            }
        }
        for (const GraphEdge& e : graph.edges)
            EXPECT_GE(at[e.to].x, at[e.from].x + graph.sizes[e.from].x + gaps.x - 0.1f) << seed;
    }
    EXPECT_GT(edges, 400u);
}

TEST(graph_layout, is_the_same_each_time)
{
    const RandomGraph graph(7);
    EXPECT_EQ(lay_out_graph(graph.sizes, graph.edges, gaps), lay_out_graph(graph.sizes, graph.edges, gaps));
    EXPECT_TRUE(lay_out_graph({}, {}, gaps).empty());
}

TEST(graph_layout, boxes_stand_beside_those_they_are_joined_with)
{
    // Two rows whose edges cross if they stand in order: 0 to 3, 1 to 2.
    const std::vector<vec2> sizes(4, {10, 10});
    const std::vector<GraphEdge> edges{{0, 3}, {1, 2}};
    const std::vector<vec2> at = lay_out_graph(sizes, edges, gaps);
    EXPECT_NEAR(at[0].y, at[3].y, 0.1f);
    EXPECT_NEAR(at[1].y, at[2].y, 0.1f);
}

TEST(graph_layout, barycentres_leave_fewer_crossings_than_the_order_given)
{
    std::size_t given = 0, laid_out = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const RandomGraph graph(seed);
        std::vector<vec2> at = lay_out_graph(graph.sizes, graph.edges, gaps);
        laid_out += crossings(at, graph);
        std::map<float, float> bottom; // of each column, whose boxes are stacked in order
        for (std::size_t box = 0; box < at.size(); ++box) {
            at[box].y = bottom[at[box].x];
            bottom[at[box].x] += graph.sizes[box].y + gaps.y;
        }
        given += crossings(at, graph);
    }
    EXPECT_LT(laid_out, 0.8 * static_cast<double>(given));
}

std::vector<std::string> lines_of(const GraphFacts& graph)
{
    const GraphBoxes drawing = make_graph_boxes(graph);
    const auto name = [&](std::size_t box) {
        const GraphBox& b = drawing.boxes[box];
        return b.image ? "[" + graph.resources[*b.image].name + "]" : graph.passes[b.first_pass].name;
    };
    std::vector<std::string> out;
    for (const GraphLine& line : drawing.lines) {
        EXPECT_LT(line.from, line.to);
        out.push_back(name(line.from) + " > " + name(line.to));
    }
    std::sort(out.begin(), out.end());
    return out;
}

TEST(graph_boxes, lines_go_through_the_box_of_what_an_image_holds_at_last)
{
    test::GraphOfFrame frame;
    frame.image("map", true);
    frame.image("depth");
    frame.image("hdr");
    frame.buffer("commands");
    frame.pass("prepass", {}, {"depth"});
    frame.pass("cull", {"depth"}, {"commands"}); // of the depth before it is finished
    frame.pass("draw", {"commands"}, {"depth"});
    frame.pass("light", {"depth", "map"}, {"hdr"});
    frame.pass("sky", {"depth"}, {"hdr"});
    frame.pass("show", {"hdr"}, {});
    const std::vector<std::string> expected{"[depth] > light",   "[depth] > sky",  "[hdr] > show",   "[map] > light",
                                            "cull > draw",       "draw > [depth]", "light > [hdr]",  "light > sky",
                                            "prepass > [depth]", "prepass > cull", "prepass > draw", "sky > [hdr]"};
    EXPECT_EQ(lines_of(frame.facts), expected);
}

TEST(graph_boxes, passes_that_differ_by_a_number_are_one)
{
    test::GraphOfFrame frame;
    frame.image("depth");
    frame.buffer("pyramid");
    frame.pass("draw", {}, {"depth"});
    for (const char* name : {"pyramid.0", "pyramid.1", "pyramid.2"}) frame.pass(name, {"depth"}, {"pyramid"});
    frame.pass("shadow.0", {"pyramid"}, {});
    frame.pass("shadow.0.ranges.0", {}, {});
    const GraphBoxes drawing = make_graph_boxes(frame.facts);
    ASSERT_EQ(drawing.boxes.size(), 5u);
    EXPECT_EQ(drawing.boxes[2].first_pass, 1u);
    EXPECT_EQ(drawing.boxes[2].passes, 3u);
    EXPECT_EQ(drawing.lines.size(), 3u); // none from the pyramid's passes to each other
}

TEST(graph_boxes, of_a_frame_without_passes_there_are_none)
{
    EXPECT_TRUE(make_graph_boxes({}).boxes.empty());
}

} // namespace
} // namespace atrium::gui
