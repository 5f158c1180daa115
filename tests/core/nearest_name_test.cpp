#include "renderer/core/nearest_name.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace atrium {
namespace {

TEST(nearest_name, finds_the_smallest_edit_distance)
{
    const std::vector<std::string> names{"ao.method", "ao.radius", "shadow.filter", "shadow.samples"};
    EXPECT_EQ(nearest_name("ao.radius", names), "ao.radius");
    EXPECT_EQ(nearest_name("ao.radis", names), "ao.radius");           // delete
    EXPECT_EQ(nearest_name("shadow.filteer", names), "shadow.filter"); // insert
    EXPECT_EQ(nearest_name("ao.mathod", names), "ao.method");          // replace
}

TEST(nearest_name, a_swap_of_neighbours_is_one_edit)
{
    // "ab" to "ba" is one swap; to "xb" it is one replacement too, to "axbx" two inserts.
    const std::vector<std::string> names{"axbx", "ba"};
    EXPECT_EQ(nearest_name("ab", names), "ba");
    // Without the swap, "fliter" would be two edits from "filter" and equally far from "flite", one delete.
    const std::vector<std::string> tie{"filter", "fliterxx"};
    EXPECT_EQ(nearest_name("fliter", tie), "filter");
}

TEST(nearest_name, takes_the_first_of_equals)
{
    const std::vector<std::string> names{"cat", "bat"};
    EXPECT_EQ(nearest_name("rat", names), "cat");
}

TEST(nearest_name, survives_nothing_and_very_much)
{
    EXPECT_EQ(nearest_name("x", {}), "");
    const std::vector<std::string> names{"abc", "d"};
    EXPECT_EQ(nearest_name("", names), "");
    EXPECT_EQ(nearest_name(std::string(8'000'000, 'x'), names), ""); // at once: only its beginning is compared
}

TEST(nearest_name, offers_what_a_typing_mistake_explains_and_nothing_else)
{
    const std::vector<std::string> filters{"off", "hard", "pcf", "pcss"};
    EXPECT_EQ(nearest_name("temporal", filters), "");
    EXPECT_EQ(nearest_name("of", filters), "off");
    EXPECT_EQ(nearest_name("psf", filters), "pcf");
    EXPECT_EQ(nearest_name("hrad", filters), "hard");
    EXPECT_EQ(nearest_name("soft", filters), ""); // two letters of four
    const std::vector<std::string> commands{"render", "view", "bench", "settings", "devices"};
    EXPECT_EQ(nearest_name("rendr", commands), "render");
    EXPECT_EQ(nearest_name("frobnicate", commands), "");
    const std::vector<std::string> options{"-o", "--fov", "--size"};
    EXPECT_EQ(nearest_name("-x", options), ""); // nothing of it is right
    EXPECT_EQ(nearest_name("--sizee", options), "--size");
}

TEST(nearest_name, a_beginning_or_a_last_part_is_enough)
{
    const std::vector<std::string> names{"tonemap.operator", "shadow.radius", "shadow.resolution", "fov"};
    EXPECT_EQ(nearest_name("tonemap.op", names), ""); // two letters begin too much
    EXPECT_EQ(nearest_name("tonemap.oper", names), "tonemap.operator");
    EXPECT_EQ(nearest_name("tonemap", names), "tonemap.operator");
    EXPECT_EQ(nearest_name("radius", names), "shadow.radius");
    EXPECT_EQ(nearest_name("fovy", names), "fov");
    // Letters of a group that both share do not count: they would let anything pass.
    EXPECT_EQ(nearest_name("shadow.strength", names), "");
}

TEST(nearest_name, advice_names_the_near_one_or_the_few_that_there_are)
{
    const std::vector<std::string> filters{"off", "hard", "pcf"}, options{"--size"};
    EXPECT_EQ(did_you_mean("hrad", filters), "did you mean \"hard\"?");
    EXPECT_EQ(did_you_mean("--sizee", options), "did you mean --size?");
    EXPECT_EQ(did_you_mean("temporal", filters), "");
    EXPECT_EQ(did_you_mean("temporal", filters, "choose"), "choose");
    EXPECT_EQ(suggest_name("temporal", filters), "choose one of off, hard, pcf");
    EXPECT_EQ(suggest_name("hrad", filters), "did you mean \"hard\"?");
    EXPECT_EQ(suggest_name("temporal", std::vector<std::string>(100, "other")), ""); // a list that nobody reads
}

} // namespace
} // namespace atrium
