#include "app/view/comparison.hpp"

#include <gtest/gtest.h>

namespace atrium::app {
namespace {

TEST(comparison, differences_are_absolute_amplified_and_end_at_white)
{
    Image8 a(2, 1, 3, 100), b = a;
    b.values = {100, 101, 99, 0, 255, 163};
    EXPECT_EQ(amplified_difference(a, b, 4).values, (std::vector<std::uint8_t>{0, 4, 4, 255, 255, 252}));
    EXPECT_EQ(amplified_difference(a, b, 4).values, amplified_difference(b, a, 4).values);
}

} // namespace
} // namespace atrium::app
