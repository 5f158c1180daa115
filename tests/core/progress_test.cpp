#include "renderer/core/progress.hpp"

#include <gtest/gtest.h>

namespace atrium {
namespace {

TEST(progress, tells_the_time_that_is_left)
{
    EXPECT_EQ(time_left(240.4, 10), "240 ms each, 3 s left"); // never sooner than it is
    EXPECT_EQ(time_left(1000, 65), "1000 ms each, 1 min 5 s left");
    EXPECT_EQ(time_left(12, 0), "12 ms each, 0 s left");
}

} // namespace
} // namespace atrium
