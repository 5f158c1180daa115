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
    EXPECT_EQ(nearest_name("", names), "d");
    EXPECT_EQ(nearest_name(std::string(8'000'000, 'x'), names), "abc"); // at once: only its beginning is compared
}

} // namespace
} // namespace atrium
