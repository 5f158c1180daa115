// Sample sets: how even they are, whole and in part, and that they stay what they are.

#include "renderer/techniques/shadow/sample_sets.hpp"

#include "renderer/core/hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>

namespace atrium {
namespace {

using glm::dvec2;
using Maker = std::vector<vec2> (*)(int count, std::uint64_t seed);

constexpr std::uint64_t seeds = 30;

/// The least distance between two points, in that of the densest packing of as many.
double evenness(std::span<const vec2> points, bool wraps)
{
    double least = 4;
    for (const vec2& a : points) {
        for (const vec2& b : points) {
            dvec2 d = glm::abs(dvec2(a) - dvec2(b));
            if (wraps) d = glm::min(d, 2.0 - d);
            if (&a != &b) least = std::min(least, glm::length(d));
        }
    }
    const double area = wraps ? 4 : std::numbers::pi;
    return least / std::sqrt(2 * area / (std::numbers::sqrt3 * static_cast<double>(points.size())));
}

double mean_length(const std::vector<vec2>& points)
{
    dvec2 sum(0);
    for (const vec2& p : points) sum += p;
    return glm::length(sum) / static_cast<double>(points.size());
}

/// The least evenness over all seeds of sets of 16, 32 and 64, and of their first 4, 8, ... points.
struct Evenness {
    double whole = 1, first = 1;
};

Evenness least_evenness(Maker make, bool wraps)
{
    Evenness least;
    for (const int count : {16, 32, 64}) {
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            const std::vector<vec2> points = make(count, seed);
            least.whole = std::min(least.whole, evenness(points, wraps));
            for (std::size_t n = 4; n < points.size(); n *= 2)
                least.first = std::min(least.first, evenness(std::span(points).first(n), wraps));
        }
    }
    return least;
}

TEST(sample_sets, weights_are_those_of_the_paper)
{
    EXPECT_NEAR(packing_radius(std::numbers::pi, 16), 0.238078, 1e-6);
    EXPECT_NEAR(packing_radius(2 * std::numbers::sqrt3, 1), 1, 1e-12); // the hexagon around a unit disc
    EXPECT_FLOAT_EQ(elimination_weight(0.5, 0.125, 0.5), 1.0f / 256);
    EXPECT_FLOAT_EQ(elimination_weight(0.75, 0.125, 0.5), 1.0f / 65536);
    EXPECT_FLOAT_EQ(elimination_weight(0.25, 0.125, 0.5), 6561.0f / 65536);
    EXPECT_FLOAT_EQ(elimination_weight(0.01, 0.125, 0.5), 6561.0f / 65536);
    EXPECT_EQ(elimination_weight(1, 0.125, 0.5), 0);
    EXPECT_EQ(elimination_weight(1.5, 0.125, 0.5), 0);
}

TEST(sample_sets, discs_are_even_whole_and_in_part)
{
    const Evenness least = least_evenness(disc_samples, false);
    EXPECT_GE(least.whole, 0.74);
    EXPECT_GE(least.first, 0.67);
}

TEST(sample_sets, squares_are_even_around_their_sides)
{
    const Evenness least = least_evenness(square_samples, true);
    EXPECT_GE(least.whole, 0.69);
    EXPECT_GE(least.first, 0.58);
}

TEST(sample_sets, random_sets_are_not_even)
{
    std::mt19937 random(1);
    for (const std::size_t count : {16u, 32u, 64u}) {
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            std::vector<vec2> points;
            while (points.size() < count) {
                const dvec2 p = dvec2{random(), random()} * 0x1p-31 - 1.0;
                if (glm::length(p) <= 1) points.emplace_back(p);
            }
            EXPECT_LE(evenness(points, false), 0.4);
        }
    }
}

TEST(sample_sets, every_count_is_even_centred_and_inside)
{
    for (int count = 4; count <= 64; ++count) {
        const std::vector<vec2> disc = disc_samples(count, 7), square = square_samples(count, 7);
        ASSERT_EQ(static_cast<int>(disc.size()), count);
        ASSERT_EQ(static_cast<int>(square.size()), count);
        EXPECT_GE(evenness(disc, false), 0.69) << count;
        EXPECT_GE(evenness(square, true), 0.69) << count;
        EXPECT_LT(mean_length(disc), 0.03) << count;
        EXPECT_LT(mean_length(square), 0.03) << count;
        for (const vec2& p : disc) EXPECT_LE(glm::length(dvec2(p)), 1) << count;
        for (const vec2& p : square) EXPECT_TRUE(p.x >= -1 && p.x < 1 && p.y >= -1 && p.y < 1) << count;
    }
    EXPECT_THROW(static_cast<void>(disc_samples(3, 0)), std::logic_error);
    EXPECT_THROW(static_cast<void>(square_samples(65, 0)), std::logic_error);
}

TEST(sample_sets, no_seed_leaves_a_close_pair)
{
    // Of squares of five, elimination alone spoils one in a hundred.
    for (std::uint64_t seed = 0; seed < 1000; ++seed) ASSERT_GE(evenness(square_samples(5, seed), true), 0.69) << seed;
}

TEST(sample_sets, a_seed_gives_the_same_bytes_everywhere)
{
    for (const Maker make : {disc_samples, square_samples}) {
        EXPECT_EQ(make(16, 1), make(16, 1));
        EXPECT_NE(make(16, 1), make(16, 2));
    }
    const std::vector<vec2> disc = disc_samples(32, 1), square = square_samples(32, 1);
    EXPECT_EQ(hash64(std::as_bytes(std::span(disc))), 14833947890583951846u);
    EXPECT_EQ(hash64(std::as_bytes(std::span(square))), 5037681606435563444u);
}

/// RMS of what straight edges at all angles and distances cover of a set, less what they cover of the disc.
double edge_error(const std::vector<vec2>& set)
{
    double sum = 0;
    constexpr int angles = 64, steps = 80;
    for (int a = 0; a < angles; ++a) {
        const double angle = 2 * std::numbers::pi * a / angles;
        for (int k = 0; k < steps; ++k) {
            const double x = -1 + 2 * (k + 0.5) / steps;
            const auto covered = std::count_if(set.begin(), set.end(), [&](const vec2& p) {
                return static_cast<double>(p.x) * std::cos(angle) + static_cast<double>(p.y) * std::sin(angle) < x;
            });
            const double of_disc = 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi;
            const double error = static_cast<double>(covered) / static_cast<double>(set.size()) - of_disc;
            sum += error * error;
        }
    }
    return std::sqrt(sum / (angles * steps));
}

TEST(sample_sets, evened_out_discs_tell_edges_better_and_stay_in_the_disc)
{
    for (const int count : {8, 16, 32, 64}) {
        double before = 0, after = 0, square = 0;
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            std::vector<vec2> set = disc_samples(count, seed);
            before += edge_error(set);
            even_out(set);
            after += edge_error(set);
            EXPECT_LT(mean_length(set), 0.005);
            for (const vec2& p : set) {
                EXPECT_LE(glm::length(p), 1);
                square += static_cast<double>(glm::dot(p, p)) / (30.0 * count);
            }
        }
        EXPECT_LT(after, 0.83 * before) << count;
        EXPECT_NEAR(square, 0.5, 0.005) << count; // of the disc
    }
}

TEST(sample_sets, spirals_tell_edges_better_still)
{
    for (const int count : {12, 24, 48, 96, 192}) {
        const std::vector<vec2> spiral = spiral_samples(count);
        ASSERT_EQ(static_cast<int>(spiral.size()), count);
        for (const vec2& p : spiral) EXPECT_LT(glm::length(p), 1);
        // Noise of independent points would fall with the root of their number.
        EXPECT_LT(edge_error(spiral), 0.32 * std::pow(count, -0.75)) << count;
    }
}

TEST(sample_sets, a_lattice_has_each_of_its_rows_and_columns_once)
{
    for (const int count : {4, 21, 32, 96, 192}) {
        const std::vector<vec2> lattice = lattice_samples(count);
        ASSERT_EQ(static_cast<int>(lattice.size()), count);
        for (int axis = 0; axis < 2; ++axis) {
            std::vector<float> at;
            for (const vec2& p : lattice) at.push_back(0.5f * p[axis] + 0.5f);
            std::sort(at.begin(), at.end());
            at.push_back(at.front() + 1); // around its sides
            for (std::size_t i = 1; i < at.size(); ++i) {
                EXPECT_LT(at[i] - at[i - 1], 1.8 / count) << count;
                EXPECT_GT(at[i] - at[i - 1], 0.3 / count) << count;
            }
        }
    }
}

} // namespace
} // namespace atrium
