#pragma once
// The comparisons as GoogleTest assertions: EXPECT_TRUE(within(compare_depth(…), 0.995, "courtyard-depth")).

#include "tests/truth/compare.hpp"
#include "tests/truth/golden.hpp"

#include <gtest/gtest.h>

namespace atrium::truth {

/// Holds when at least `share` of the compared pixels are within tolerance. Writes pictures called `name` otherwise.
inline testing::AssertionResult within(const Agreement& agreement, double share, const std::string& name)
{
    if (agreement.compared > 0 && agreement.share_within >= share) {
        return testing::AssertionSuccess() << name << ": " << agreement.text();
    }
    return testing::AssertionFailure() << name << ": " << agreement.text() << "; wanted " << 100 * share << " %\n"
                                       << write_failure(name, agreement);
}

inline testing::AssertionResult passed(const GoldenResult& result)
{
    return (result.passed ? testing::AssertionSuccess() : testing::AssertionFailure()) << result.text;
}

} // namespace atrium::truth
