#pragma once
// What a call throws, for tests of messages.

#include "renderer/core/error.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace atrium::test {

template <class F>
std::optional<Error> error_of(F&& call)
{
    try {
        call();
    } catch (const Error& e) {
        return e;
    }
    return std::nullopt;
}

/// The call throws an Error with the code, and each of `parts` stands in its text.
template <class F, class... Parts>
void expect_error(F&& call, ExitCode code, const Parts&... parts)
{
    const auto error = error_of(call);
    ASSERT_TRUE(error.has_value()) << "nothing was thrown";
    EXPECT_EQ(static_cast<int>(error->code()), static_cast<int>(code)) << error->text();
    for (const std::string& part : std::vector<std::string>{parts...}) {
        EXPECT_NE(error->text().find(part), std::string::npos) << "no \"" << part << "\" in:\n" << error->text();
    }
}

} // namespace atrium::test
