#include "renderer/techniques/shadow/sample_sets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

namespace atrium {
namespace {

// Platforms agree to the bit: coordinates are multiples of 2^-23, so that their sums and squared distances are exact in
// double. Weights are rounded to float lest a compiler fuse their last product with the sum that they are added to.

using glm::dvec2;

/// SplitMix64. Source: Steele et al. 2014, "Fast Splittable Pseudorandom Number Generators".
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    /// Uniform in [-1, 1)².
    dvec2 point() { return {coordinate(), coordinate()}; }

private:
    double coordinate() { return static_cast<double>(next() >> 40) * 0x1p-23 - 1; }
    std::uint64_t next()
    {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

struct Disc {
    static constexpr double area = std::numbers::pi;
    static bool contains(const dvec2& p) { return glm::dot(p, p) <= 1; }
    static double squared_distance(const dvec2& a, const dvec2& b) { return glm::dot(a - b, a - b); }
};

struct WrappedSquare {
    static constexpr double area = 4;
    static bool contains(const dvec2&) { return true; }
    static double squared_distance(const dvec2& a, const dvec2& b)
    {
        const double x = shorter(a.x - b.x), y = shorter(a.y - b.y);
        return x * x + y * y;
    }
    /// Of the ways inside and around.
    static double shorter(double offset) { return 1 - std::abs(1 - std::abs(offset)); }
};

/// Brings the `keep` points that crowd each other least to the front. Behind them are the others, the first to go last.
template <class Domain>
void eliminate(std::span<dvec2> points, std::size_t keep)
{
    const double share = static_cast<double>(keep) / static_cast<double>(points.size());
    const double r_max = packing_radius(Domain::area, static_cast<int>(keep));
    const double r_min = r_max * (1 - std::sqrt(share * share * share)) * 0.65;
    const double reach = 4 * r_max * r_max;
    const auto weight = [=](const dvec2& a, const dvec2& b) { // most pairs are too far apart to need the root
        const double squared = Domain::squared_distance(a, b);
        return squared < reach ? elimination_weight(std::sqrt(squared), r_min, r_max) : 0.0f;
    };

    std::vector<double> crowding(points.size()); // of each point, the sum of its weights
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const float w = weight(points[i], points[j]);
            if (w == 0) continue;
            crowding[i] += w;
            crowding[j] += w;
        }
    }
    auto worst = static_cast<std::size_t>(std::max_element(crowding.begin(), crowding.end()) - crowding.begin());
    for (std::size_t last = points.size() - 1; last >= keep; --last) {
        std::swap(points[worst], points[last]);
        std::swap(crowding[worst], crowding[last]);
        worst = 0;
        for (std::size_t i = 0; i < last; ++i) {
            crowding[i] -= weight(points[i], points[last]);
            if (crowding[i] > crowding[worst]) worst = i;
        }
    }
}

/// Is no pair closer than disc_samples() promises?
template <class Domain>
bool even(std::span<const dvec2> points)
{
    const double least = 0.69 * 2 * packing_radius(Domain::area, static_cast<int>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (Domain::squared_distance(points[i], points[j]) < least * least) return false;
        }
    }
    return true;
}

/// An even set in progressive order.
template <class Domain>
std::vector<dvec2> even_points(int count, Random& random)
{
    if (count < 4 || count > 64) throw std::logic_error("a sample set has 4 to 64 points");
    const auto size = static_cast<std::size_t>(count);
    std::vector<dvec2> points(10 * size); // more gain little, and take time by their square
    do { // again for a square in hundreds: around its sides, a small set may be left with a close pair
        for (dvec2& p : points) {
            do p = random.point();
            while (!Domain::contains(p));
        }
        eliminate<Domain>(points, size);
    } while (!even<Domain>(std::span(points).first(size)));
    points.resize(size);
    for (std::size_t n = size; n > 2; n /= 2) eliminate<Domain>(std::span(points).first(n), n / 2);
    return points;
}

/// A mean off the centre would shift every shadow.
bool centred(const std::vector<dvec2>& points)
{
    const dvec2 sum = std::accumulate(points.begin(), points.end(), dvec2(0));
    return glm::length(sum) < 0.03 * static_cast<double>(points.size());
}

} // namespace

double packing_radius(double area, int count)
{
    return std::sqrt(area / (2 * std::numbers::sqrt3 * count));
}

float elimination_weight(double distance, double r_min, double r_max)
{
    if (distance >= 2 * r_max) return 0;
    const double x = 1 - std::max(distance, 2 * r_min) / (2 * r_max);
    const double x2 = x * x, x4 = x2 * x2;
    return static_cast<float>(x4 * x4);
}

std::vector<vec2> disc_samples(int count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<dvec2> points;
    do points = even_points<Disc>(count, random);
    while (!centred(points));
    return {points.begin(), points.end()};
}

std::vector<vec2> square_samples(int count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<dvec2> points = even_points<WrappedSquare>(count, random);
    while (!centred(points)) { // any shift leaves it as even
        const dvec2 shift = random.point();
        for (dvec2& p : points) p = glm::mod(p + shift + 1.0, 2.0) - 1.0;
    }
    return {points.begin(), points.end()};
}

std::vector<vec2> spiral_samples(int count)
{
    constexpr float golden_angle = 2 * std::numbers::pi_v<float> * (1 - 1 / std::numbers::phi_v<float>);
    std::vector<vec2> points;
    for (int i = 0; i < count; ++i) {
        const float radius = std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(count));
        const float angle = golden_angle * static_cast<float>(i);
        points.push_back(radius * vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

std::vector<vec2> lattice_samples(int count)
{
    std::vector<vec2> points;
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<float>(i);
        points.push_back(
            glm::fract(vec2((k + 0.5f) / static_cast<float>(count), k * std::numbers::phi_v<float>)) * 2.0f - 1.0f);
    }
    return points;
}

void even_out(std::vector<vec2>& disc)
{
    std::vector<std::size_t> by_radius(disc.size());
    std::iota(by_radius.begin(), by_radius.end(), std::size_t{0});
    std::stable_sort(by_radius.begin(), by_radius.end(), [&](std::size_t a, std::size_t b) {
        return glm::dot(disc[a], disc[a]) < glm::dot(disc[b], disc[b]);
    });
    const auto count = static_cast<float>(disc.size());
    constexpr int rounds = 8; // each takes most of what is left of the mean
    for (int round = 0; round < rounds; ++round) {
        const vec2 mean = std::accumulate(disc.begin(), disc.end(), vec2(0)) / count;
        for (std::size_t i = 0; i < by_radius.size(); ++i) {
            vec2& p = disc[by_radius[i]];
            p -= mean;
            p *= std::sqrt((static_cast<float>(i) + 0.5f) / count) / std::max(glm::length(p), 1e-6f);
        }
    }
}

} // namespace atrium
