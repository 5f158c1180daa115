// ARCHITECTURE.md's worked examples of history, storage images and mips, compiled and run with the same text.

#include "tests/examples/average.hpp"
#include "tests/examples/mip_chain.hpp"
#include "tests/examples/sharpen.hpp"
#include "tests/gpu/graph_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace atrium {
namespace {

using rig::GraphRig;

constexpr uvec2 small{8, 4};

/// The average after one more picture of one colour, a fourth of it new.
float average_of(GraphRig& rig, float value, uvec2 size = small, bool cut = false, const std::string& view = "main")
{
    graph::Graph g = rig.begin({size, size, view, cut});
    const std::vector<float> out = rig.run(g, add_average(g, rig.plain(g, size, value), 0.25f));
    for (const float v : out) EXPECT_EQ(v, out.front());
    return out.front();
}

TEST(example_average, mixes_each_picture_into_those_before)
{
    GraphRig rig;
    EXPECT_EQ(average_of(rig, 1), 1) << "the first frame has no history";
    EXPECT_EQ(average_of(rig, 0), 0.75f);
    EXPECT_EQ(average_of(rig, 0), 0.5625f);
    EXPECT_EQ(average_of(rig, 1), 0.671875f);
}

TEST(example_average, starts_again_at_a_cut_and_at_another_size)
{
    GraphRig rig;
    average_of(rig, 1);
    EXPECT_EQ(average_of(rig, 0, small, true), 0) << "a cut";
    EXPECT_EQ(average_of(rig, 1), 0.25f);
    EXPECT_EQ(average_of(rig, 1, {4, 4}), 1) << "another size";
    EXPECT_EQ(average_of(rig, 0, {4, 4}), 0.75f);
    EXPECT_EQ(average_of(rig, 0, small), 0) << "the first size again";
}

TEST(example_average, of_two_views_are_two)
{
    GraphRig rig;
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(average_of(rig, 1), 1);
        EXPECT_EQ(average_of(rig, 0, small, false, "other"), 0);
    }
    EXPECT_EQ(average_of(rig, 0), 0.75f);
}

TEST(example_sharpen, equals_the_sum_over_neighbours)
{
    constexpr uvec2 size(21, 13); // no multiple of a work group
    std::mt19937 random(5);
    std::vector<float> values(std::size_t{4} * size.x * size.y);
    for (float& v : values) v = static_cast<float>(random() % 1024) / 64;
    const auto at = [&](int x, int y, std::size_t c) {
        const int cx = std::clamp(x, 0, static_cast<int>(size.x) - 1),
                  cy = std::clamp(y, 0, static_cast<int>(size.y) - 1);
        return values[4 * (static_cast<std::size_t>(cy) * size.x + static_cast<std::size_t>(cx)) + c];
    };
    GraphRig rig;
    graph::Graph g = rig.begin();
    const std::vector<float> out = rig.run(g, add_sharpen(g, rig.upload(g, size, values), 0.5f));
    for (int y = 0; y < static_cast<int>(size.y); ++y) {
        for (int x = 0; x < static_cast<int>(size.x); ++x) {
            for (std::size_t c = 0; c < 4; ++c) {
                const float around = 0.25f * (at(x + 1, y, c) + at(x - 1, y, c) + at(x, y + 1, c) + at(x, y - 1, c));
                const std::size_t i = 4 * (static_cast<std::size_t>(y) * size.x + static_cast<std::size_t>(x)) + c;
                ASSERT_NEAR(out[i], 1.5f * at(x, y, c) - 0.5f * around, 1e-5f) << x << "," << y;
            }
        }
    }
}

TEST(example_mip_chain, every_mip_is_the_mean_of_the_one_before)
{
    constexpr uvec2 size(16, 8);
    std::mt19937 random(6);
    std::vector<float> finer(std::size_t{4} * size.x * size.y);
    for (float& v : finer) v = static_cast<float>(random() % 256);
    const std::vector<float> picture = finer;
    GraphRig rig;
    uvec2 of(size);
    for (std::uint32_t mip = 0; mip < 4; ++mip) {
        graph::Graph g = rig.begin();
        const graph::Tex chain = add_mip_chain(g, rig.upload(g, size, picture));
        ASSERT_EQ(g.desc(chain).mips, 4u);
        const std::vector<float> out = rig.run(g, chain, mip);
        const uvec2 half = glm::max(of / 2u, uvec2(1));
        std::vector<float> wanted(std::size_t{4} * half.x * half.y);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const std::size_t x = i / 4 % half.x, y = i / 4 / half.x;
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t fx = std::min<std::size_t>(2 * x + k % 2, of.x - 1);
                const std::size_t fy = std::min<std::size_t>(2 * y + k / 2, of.y - 1);
                wanted[i] += 0.25f * finer[4 * (fy * of.x + fx) + i % 4];
            }
        }
        EXPECT_EQ(out, wanted) << "mip " << mip; // sums of few bits are exact
        finer = wanted;
        of = half;
    }
}

std::string text_of(const std::string& file)
{
    std::ifstream in(std::string(ATRIUM_SOURCE) + "/" + file);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(examples, take_less_than_60_lines_each_and_stand_in_the_architecture_page)
{
    const std::string page = text_of("ARCHITECTURE.md");
    for (const auto& [header, shader] : {std::pair("average.hpp", "average.frag"),
                                         {"sharpen.hpp", "sharpen.comp"},
                                         {"mip_chain.hpp", "mip_chain.frag"}}) {
        std::ptrdiff_t lines = 0;
        for (const char* name : {header, shader}) {
            const std::string text = text_of(std::string("tests/examples/") + name);
            lines += std::count(text.begin(), text.end(), '\n');
            EXPECT_NE(page.find(text), std::string::npos) << name;
        }
        EXPECT_GT(lines, 10) << header;
        EXPECT_LT(lines, 60) << header;
    }
}

} // namespace
} // namespace atrium
