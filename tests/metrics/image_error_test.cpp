// Mean squared error, PSNR and SSIM against known values.

#include "renderer/metrics/image_error.hpp"
#include "tests/metrics/pictures.hpp"

#include <gtest/gtest.h>

namespace atrium {
namespace {

TEST(image_error, known_pairs)
{
    for (const KnownPair& pair : known_pairs()) {
        const double mse = mean_squared_error(pair.reference, pair.test);
        EXPECT_NEAR(mse, pair.mse, 1e-6) << pair.name;
        EXPECT_NEAR(peak_signal_to_noise(mse, 1).value_or(-1), pair.psnr, 1e-3) << pair.name;
        EXPECT_NEAR(structural_similarity(pair.reference, pair.test).value_or(-1), pair.ssim, 1e-5) << pair.name;
    }
}

TEST(image_error, of_equal_pictures)
{
    const ImageF image = uniform({10, 200, 30});
    EXPECT_EQ(mean_squared_error(image, image), 0);
    EXPECT_FALSE(peak_signal_to_noise(0, 1));
    EXPECT_NEAR(structural_similarity(image, image).value_or(0), 1, 1e-12);
}

TEST(image_error, a_window_must_fit_into_the_picture)
{
    EXPECT_FALSE(structural_similarity(ImageF(10, 20, 3), ImageF(10, 20, 3)));
    EXPECT_TRUE(structural_similarity(ImageF(11, 11, 3), ImageF(11, 11, 3)));
}

TEST(image_error, alpha_does_not_count)
{
    const ImageF opaque(12, 12, 4, 1.0f);
    ImageF clear = opaque;
    for (std::size_t i = 3; i < clear.values.size(); i += 4) clear.values[i] = 0;
    EXPECT_EQ(mean_squared_error(opaque, clear), 0);
    EXPECT_EQ(peak_of(clear), 1);
}

} // namespace
} // namespace atrium
