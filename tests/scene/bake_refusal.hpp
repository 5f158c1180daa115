#pragma once
// The message of a refusal, for tests that want one.

#include "renderer/core/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace atrium::bake_rig {

/// The text of the Error(input) that `act` throws. A failure of the test when it throws nothing or something else.
template <class Act>
std::string refusal(Act&& act)
{
    try {
        act();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::input) << e.text();
        EXPECT_FALSE(e.where().empty() || e.why().empty() || e.next().empty()) << e.text();
        return e.text();
    }
    ADD_FAILURE() << "not refused";
    return "";
}

inline bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace atrium::bake_rig
