#include "scripts/fit_ltc/fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace atrium {
namespace {

constexpr double pi_d = 3.14159265358979323846;

/// A direction to the light, and the lobe there.
struct Sample {
    glm::dvec3 l;
    double lobe;    ///< D V n.l, F = 1
    double fresnel; ///< (1 - v.h)^5
    double weight;  ///< solid angle, sr
};

/// Half the hemisphere (the lobe is symmetric in y), placed as the microfacets' normals are: as many near the peak as
/// in the tail, at every roughness.
std::vector<Sample> sample_lobe(double roughness, double n_v)
{
    constexpr int rings = 64, sectors = 48;
    const double alpha = roughness * roughness, a2 = alpha * alpha, sine = std::sqrt(1 - n_v * n_v);
    const glm::dvec3 v(-sine, 0, n_v);
    std::vector<Sample> out;
    for (int i = 0; i < rings; ++i) {
        const double u = (i + 0.5) / rings, tangent = alpha * u / (1 - u), cosine = 1 / std::hypot(1, tangent);
        const double d_theta = alpha * cosine * cosine / ((1 - u) * (1 - u) * rings);
        for (int k = 0; k < sectors; ++k) {
            const double phi = pi_d * (k + 0.5) / sectors;
            const glm::dvec3 h = cosine * glm::dvec3(tangent * std::cos(phi), tangent * std::sin(phi), 1);
            const double v_h = glm::dot(v, h);
            const glm::dvec3 l = 2 * v_h * h - v;
            if (v_h <= 0 || l.z <= 0) continue;
            const double d = cosine * cosine * (a2 - 1) + 1;
            const double smith =
                l.z * std::sqrt(n_v * n_v * (1 - a2) + a2) + n_v * std::sqrt(l.z * l.z * (1 - a2) + a2);
            out.push_back({l, a2 / (2 * pi_d * d * d * smith) * l.z, std::pow(1 - v_h, 5),
                           4 * v_h * cosine * tangent * d_theta * (2 * pi_d / sectors)});
        }
    }
    return out;
}

/// (log along, log across, skew) of a lobe.
using Shape = glm::dvec3;

/// Variance of log(f / g), weighted with f, its half gradient and Gauss-Newton's matrix for the shape of g.
struct Misfit {
    double variance = 0;
    glm::dvec3 gradient{0};
    glm::dmat3 normal{0};
};

Misfit misfit(const std::vector<Sample>& samples, const Shape& shape)
{
    const double inv_along = std::exp(-shape.x), inv_across = std::exp(-shape.y);
    double sum = 0, mean = 0, square = 0;
    glm::dvec3 slope(0), product(0);
    glm::dmat3 outer(0);
    for (const Sample& s : samples) {
        const double a = (s.l.x - shape.z * s.l.z) * inv_along, b = s.l.y * inv_across;
        const double length2 = a * a + b * b + s.l.z * s.l.z, w = s.lobe * s.weight;
        const double log_g = std::log(s.l.z) - shape.x - shape.y - 2 * std::log(length2);
        const glm::dvec3 d_log_g =
            glm::dvec3(4 * a * a, 4 * b * b, 4 * a * s.l.z * inv_along) / length2 - glm::dvec3(1, 1, 0);
        const double r = std::log(s.lobe) - log_g;
        sum += w;
        mean += w * r;
        square += w * r * r;
        slope += w * d_log_g;
        product += w * r * d_log_g;
        outer += w * glm::outerProduct(d_log_g, d_log_g);
    }
    mean /= sum;
    slope /= sum;
    return {square / sum - mean * mean, product / sum - mean * slope, outer / sum - glm::outerProduct(slope, slope)};
}

/// Levenberg and Marquardt's descent.
Shape descend(const std::vector<Sample>& samples, Shape shape, double& variance)
{
    Misfit here = misfit(samples, shape);
    double damping = 1e-3;
    for (int i = 0; i < 200 && damping < 1e9; ++i) {
        glm::dmat3 damped = here.normal;
        for (int k = 0; k < 3; ++k) damped[k][k] *= 1 + damping;
        const glm::dvec3 step = glm::inverse(damped) * here.gradient;
        const Shape next = shape + step / std::max({1.0, std::abs(step.x), std::abs(step.y)});
        const Misfit there = misfit(samples, next);
        if (!(there.variance < here.variance)) {
            damping *= 4;
            continue;
        }
        const bool done = here.variance - there.variance < 1e-12 * here.variance;
        shape = next;
        here = there;
        damping = std::max(damping / 5, 1e-12);
        if (done) break;
    }
    variance = here.variance;
    return shape;
}

} // namespace

double ltc_roughness(unsigned row)
{
    return shared::ltc_rough_min + (1 - shared::ltc_rough_min) * row / (shared::ltc_size - 1);
}

double ltc_cosine(unsigned column)
{
    const double root = static_cast<double>(column) / (shared::ltc_size - 1);
    return std::clamp(root * root, 2.5e-4, 0.9995);
}

shared::LtcEntry fit_ltc(double roughness, double n_v)
{
    const std::vector<Sample> samples = sample_lobe(roughness, n_v);
    const double alpha = roughness * roughness, t = std::sqrt(1 - n_v * n_v) / n_v;
    // A narrow lobe's shape, a wide one's, and one between: a descent from afar may end in a worse valley.
    const Shape narrow(std::log(2 * alpha / (n_v * n_v)), std::log(2 * alpha), t);
    const Shape between(narrow.x - 3, narrow.y, 0.2 * t), wide(std::log(alpha), narrow.y, 0);
    double best = 1e30;
    Shape shape(0);
    for (const Shape& start : {narrow, between, wide}) {
        double variance = 0;
        const Shape found = descend(samples, start, variance);
        if (variance < best) {
            best = variance;
            shape = found;
        }
    }
    double albedo = 0, fresnel = 0;
    for (const Sample& s : samples) {
        albedo += s.lobe * s.weight;
        fresnel += s.lobe * s.fresnel * s.weight;
    }
    return {static_cast<float>((shape.x - std::log(2 * alpha / (n_v * n_v))) / std::log(2.0)),
            static_cast<float>((shape.y - std::log(2 * alpha)) / std::log(2.0)), static_cast<float>(shape.z / t),
            static_cast<float>(albedo), static_cast<float>(fresnel)};
}

} // namespace atrium
