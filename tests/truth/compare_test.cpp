// Comparisons of pictures with planted differences.

#include "tests/truth/expect.hpp"

#include "renderer/core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace atrium::truth {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

/// A folder for failures of this test alone.
class Compare : public testing::Test {
protected:
    Compare()
    {
        std::string name = (std::filesystem::temp_directory_path() / "atrium-compare-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        const char* before = std::getenv("ATRIUM_TEST_OUT");
        if (before != nullptr) before_ = before;
        ::setenv("ATRIUM_TEST_OUT", folder_.c_str(), 1);
        ::unsetenv("ATRIUM_UPDATE_GOLDENS");
    }
    ~Compare() override
    {
        before_.empty() ? ::unsetenv("ATRIUM_TEST_OUT") : ::setenv("ATRIUM_TEST_OUT", before_.c_str(), 1);
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    [[nodiscard]] bool wrote(const char* name) const { return std::filesystem::exists(folder_ / name); }

    std::filesystem::path folder_;
    std::string before_;
};

TEST_F(Compare, depth_counts_relative_errors_off_the_mask)
{
    ImageF truth(4, 1, 1, 10.0f), actual = truth;
    Mask mask(4, 1, true);
    actual.values = {10.01f, 9.9f, 10, 99};
    mask.set(3, 0, false);
    const Agreement a = compare_depth(truth, actual, mask, 0.002);
    EXPECT_EQ(a.compared, 3u);
    EXPECT_NEAR(a.share_within, 2.0 / 3, 1e-9);
    EXPECT_NEAR(a.worst, 0.01, 1e-6);
    EXPECT_EQ(a.worst_pixel, ivec2(1, 0));
    EXPECT_NEAR(a.mean, (0.001 - 0.01) / 3, 1e-6); // too near is negative
    EXPECT_NEAR(a.rmse, std::sqrt((1e-6 + 1e-4) / 3), 1e-6);
    EXPECT_EQ(a.excluded_share, 0.25);
}

TEST_F(Compare, background_counts_only_where_one_side_has_it)
{
    ImageF truth(3, 1, 1, inf), actual = truth;
    truth.values[1] = 5;
    actual.values[2] = 5;
    const Agreement a = compare_depth(truth, actual, Mask(3, 1, true), 0.1);
    EXPECT_EQ(a.compared, 2u);
    EXPECT_EQ(a.share_within, 0);
    EXPECT_TRUE(std::isinf(a.worst));
    ImageF ids(3, 1, 1, -1), others = ids;
    others.values[0] = 4;
    const Agreement b = compare_indices(ids, others, Mask(3, 1, true));
    EXPECT_EQ(b.compared, 1u);
    EXPECT_EQ(b.share_within, 0);
    EXPECT_EQ(compare_depth(ImageF(2, 1, 1, inf), ImageF(2, 1, 1, inf), Mask(2, 1, true), 1).compared, 0u);
}

TEST_F(Compare, a_nan_is_never_right)
{
    const ImageF truth(1, 1, 1, 1.0f), nan(1, 1, 1, std::numeric_limits<float>::quiet_NaN());
    const Mask mask(1, 1, true);
    EXPECT_EQ(compare_depth(truth, nan, mask, 1e9).share_within, 0);
    const Agreement values = compare_values(truth, nan, mask, 1e9);
    EXPECT_EQ(values.share_within, 0);
    EXPECT_TRUE(std::isinf(values.worst) && std::isinf(values.p99));
    EXPECT_EQ(compare_indices(truth, nan, mask).share_within, 0);
    ImageF up(1, 1, 3);
    up.values = {0, 1, 0};
    EXPECT_EQ(compare_directions(up, ImageF(1, 1, 3, nan.values[0]), mask, 179).share_within, 0);
}

TEST_F(Compare, directions_are_compared_by_angle)
{
    ImageF truth(4, 1, 3), actual(4, 1, 3);
    const float half = 0.5f * 3.14159265f / 180;
    truth.values = {0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0};
    actual.values = {std::sin(half), std::cos(half), 0, 0, -1, 0, 0, 0.5f, 0, 0, 0, 0};
    const Agreement a = compare_directions(truth, actual, Mask(4, 1, true), 1);
    EXPECT_EQ(a.compared, 3u); // the last is background in both
    EXPECT_NEAR(a.error.values[0], 0.5, 1e-4);
    EXPECT_NEAR(a.error.values[1], 180, 1e-4);
    EXPECT_EQ(a.error.values[2], 180); // no unit vector
    EXPECT_NEAR(a.share_within, 1.0 / 3, 1e-9);
}

TEST_F(Compare, sizes_must_match)
{
    EXPECT_THROW((void)compare_depth(ImageF(2, 2, 1), ImageF(2, 1, 1), Mask(2, 2), 1), Error);
    EXPECT_THROW((void)compare_depth(ImageF(2, 2, 1), ImageF(2, 2, 1), Mask(1, 2), 1), Error);
    EXPECT_THROW((void)compare_directions(ImageF(2, 2, 1), ImageF(2, 2, 1), Mask(2, 2), 1), Error);
}

TEST_F(Compare, only_a_failure_leaves_pictures)
{
    ImageF truth(2, 2, 1, 1.0f), actual = truth;
    actual.values[3] = 2;
    const Mask mask(2, 2, true);
    EXPECT_TRUE(within(compare_depth(truth, actual, mask, 0.1), 0.75, "fine"));
    EXPECT_FALSE(wrote("fine-actual.png"));
    const auto result = within(compare_depth(truth, actual, mask, 0.1), 0.76, "bad");
    EXPECT_FALSE(result);
    EXPECT_NE(std::string(result.message()).find(folder_.string()), std::string::npos);
    EXPECT_TRUE(wrote("bad-expected.png"));
    EXPECT_TRUE(wrote("bad-actual.png"));
    const Image8 difference = read_png(folder_ / "bad-difference.png");
    EXPECT_EQ(difference.at(0, 0)[0], 0);
    EXPECT_EQ(difference.at(1, 1)[0], 255);
    EXPECT_FALSE(within(compare_depth(truth, actual, Mask(2, 2), 0.1), 0.5, "nothing")) << "nothing compared";
}

TEST_F(Compare, goldens_pass_and_fail_by_difference_and_share)
{
    const std::filesystem::path golden = folder_ / "picture.png";
    Image8 picture(10, 10, 3, 100);
    EXPECT_FALSE(passed(compare_golden(picture, golden, 2, 0))); // there is none
    EXPECT_TRUE(wrote("picture-actual.png"));
    ::setenv("ATRIUM_UPDATE_GOLDENS", "1", 1);
    EXPECT_TRUE(passed(compare_golden(picture, golden, 2, 0)));
    ::unsetenv("ATRIUM_UPDATE_GOLDENS");
    EXPECT_TRUE(passed(compare_golden(picture, golden, 0, 0)));

    picture.at(3, 4)[1] = 103;
    EXPECT_TRUE(passed(compare_golden(picture, golden, 3, 0)));
    EXPECT_TRUE(passed(compare_golden(picture, golden, 2, 0.01)));
    EXPECT_FALSE(wrote("picture-difference.png"));
    const GoldenResult result = compare_golden(picture, golden, 2, 0.009);
    EXPECT_FALSE(result.passed);
    EXPECT_EQ(result.largest_difference, 3);
    EXPECT_NEAR(result.failing_share, 0.01, 1e-12);
    EXPECT_NEAR(result.rmse, std::sqrt(9.0 / 300), 1e-12);
    EXPECT_EQ(read_png(folder_ / "picture-difference.png").at(3, 4)[1], 24);
    EXPECT_FALSE(passed(compare_golden(Image8(10, 9, 3, 100), golden, 255, 1)));
}

TEST_F(Compare, masks_combine_and_grow)
{
    Mask a(5, 5);
    a.set(0, 0, true);
    a.set(3, 3, true);
    EXPECT_NEAR(grown(a).share(), 13.0 / 25, 1e-12);
    EXPECT_FALSE(grown(a).at(1, 2));
    Mask b(5, 5);
    b.set(3, 3, true);
    EXPECT_EQ(both(a, b).share(), 1.0 / 25);
    EXPECT_TRUE(without(a, b).at(0, 0));
    EXPECT_FALSE(without(a, b).at(3, 3));
    EXPECT_NEAR(inverse(a).share(), 23.0 / 25, 1e-12);
}

} // namespace
} // namespace atrium::truth
