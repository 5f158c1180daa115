#include "renderer/core/text_value.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace atrium {
namespace {

TEST(text_value, the_whole_text_must_be_the_value)
{
    EXPECT_EQ(parse_int("12"), 12);
    EXPECT_EQ(parse_int("+12"), 12);
    EXPECT_EQ(parse_float("-1.5e2"), -150.0f);
    EXPECT_EQ(parse_vec3("1:-2:0.5"), vec3(1, -2, 0.5f));
    for (const char* text : {"", " 1", "1 ", "1x", "0x10", "1.5", "+-1", "--1", "99999999999", "one"}) {
        EXPECT_FALSE(parse_int(text)) << text;
    }
    for (const char* text : {"", "1,5", "nan", "inf", "-inf", "1e99", "1..2", "+", "1 2"}) {
        EXPECT_FALSE(parse_float(text)) << text;
    }
    for (const char* text : {"", "1", "1:2", "1:2:3:4", "1:2:", "::", "1:2:nan", "1,2,3"}) {
        EXPECT_FALSE(parse_vec3(text)) << text;
    }
}

TEST(text_value, words_for_booleans)
{
    EXPECT_EQ(parse_bool("on"), true);
    EXPECT_EQ(parse_bool("true"), true);
    EXPECT_EQ(parse_bool("off"), false);
    EXPECT_EQ(parse_bool("false"), false);
    for (const char* text : {"", "1", "yes", "On", "on "}) EXPECT_FALSE(parse_bool(text).has_value()) << text;
}

TEST(text_value, floats_print_shortly_and_read_back_the_same)
{
    EXPECT_EQ(to_text(0.1f), "0.1");
    EXPECT_EQ(to_text(1.0f), "1");
    EXPECT_EQ(to_text(vec3(1, -0.3f, 2)), "1:-0.3:2");
    for (const float value : {0.1f, 1.0f / 3.0f, 16777217.0f, 1e-30f, std::numeric_limits<float>::max(),
                              std::numeric_limits<float>::denorm_min()}) {
        EXPECT_EQ(parse_float(to_text(value)), value) << to_text(value);
    }
}

} // namespace
} // namespace atrium
