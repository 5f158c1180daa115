// FLIP against values of its authors' program.

#include "renderer/metrics/flip.hpp"
#include "tests/metrics/pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

TEST(flip, known_pairs)
{
    for (const KnownPair& pair : known_pairs()) {
        const ImageF map = flip_map(decoded(pair.reference), decoded(pair.test));
        EXPECT_NEAR(mean_of(map), pair.flip, 2e-4) << pair.name;
        EXPECT_NEAR(*std::max_element(map.values.begin(), map.values.end()), pair.flip_max, 1.0 / 255) << pair.name;
    }
}

TEST(flip, equal_pictures_differ_by_nothing)
{
    for (const KnownPair& pair : known_pairs())
        EXPECT_EQ(mean_of(flip_map(decoded(pair.reference), decoded(pair.reference))), 0) << pair.name;
}

/// Luminance 2^x in column x.
ImageF stops(int width)
{
    ImageF image(width, 4, 3);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < width; ++x) std::fill_n(image.at(x, y), 3, std::exp2(static_cast<float>(x)));
    }
    return image;
}

TEST(flip, exposures_reach_from_the_brightest_pixel_to_the_median)
{
    const FlipExposures e = flip_exposures(stops(9)); // median 2^4, maximum 2^8
    EXPECT_NEAR(e.start, std::log2(2.118872) - 8, 1e-5);
    EXPECT_NEAR(e.stop, std::log2(2.118872) - 4, 1e-5);
    EXPECT_EQ(e.count, 4);
}

TEST(flip, exposures_of_black_pictures_are_finite)
{
    ImageF image(8, 8, 3);
    EXPECT_EQ(flip_exposures(image).count, 2);
    std::fill_n(image.at(0, 0), 3, 2.0f); // the median of what is not black
    const FlipExposures e = flip_exposures(image);
    EXPECT_NEAR(e.start, std::log2(2.118872) - 1, 1e-5);
    EXPECT_EQ(e.start, e.stop);
}

TEST(flip, of_hdr_pictures_sees_what_one_exposure_would_clip)
{
    const ImageF reference = stops(16);
    ImageF test = reference;
    std::fill_n(test.at(15, 0), 3, std::exp2(14.0f)); // a difference among the brightest only
    const FlipExposures bright{0, 0, 2};
    EXPECT_LT(mean_of(flip_map_hdr(reference, test, bright)), 1e-3);
    EXPECT_GT(mean_of(flip_map_hdr(reference, test, flip_exposures(reference))), 1e-3);
    EXPECT_EQ(mean_of(flip_map_hdr(reference, reference, flip_exposures(reference))), 0);
}

TEST(flip, the_heat_map_goes_from_dark_to_bright)
{
    ImageF map(3, 1, 1);
    map.values = {0, 0.5f, 1};
    const Image8 picture = heat_map(map);
    EXPECT_EQ(picture.values, (std::vector<std::uint8_t>{0, 0, 4, 181, 54, 122, 252, 253, 191}));
}

} // namespace
} // namespace atrium
