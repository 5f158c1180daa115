// Rectangles against brute force: the material's own BRDF, integrated over the light in double precision.

#include "renderer/core/jobs.hpp"
#include "renderer/techniques/lighting/ltc_table.hpp"
#include "scripts/fit_ltc/fit.hpp"
#include "tests/gpu/brdf_twin.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace atrium {
namespace {

using glm::dvec3;

/// What is lit, at a pixel.
struct Point {
    dvec3 p, n, v;
    dvec3 base;
    double metallic, roughness, specular;
};

/// A rectangle of radiance 1: centre +- right +- up, shining along `normal`.
struct Rect {
    dvec3 centre, right, up, normal;
};

/// Integral over the rectangle of what leaves `at` towards the eye; red. Cells are halved until the sum stays within
/// `tolerance` and the angle of the half vector to the normal changes little within each.
class BruteForce {
public:
    BruteForce(const Point& at, const Rect& rect, double tolerance) : at_(at), rect_(rect), tolerance_(tolerance) {}

    [[nodiscard]] double radiance() const
    {
        if (glm::dot(rect_.centre - at_.p, rect_.normal) >= 0) return 0;
        // Begin where the mirrored ray meets the plane: the corner of four cells finds even the narrowest peak.
        const dvec3 c = rect_.centre - at_.p, mirrored = 2 * glm::dot(at_.n, at_.v) * at_.n - at_.v;
        const double slope = glm::dot(mirrored, rect_.normal), t = slope < 0 ? glm::dot(c, rect_.normal) / slope : 1e3;
        const dvec3 from_centre = t * mirrored - c;
        const double s0 = std::clamp(glm::dot(from_centre, rect_.right) / glm::dot(rect_.right, rect_.right), -1.0, 1.0);
        const double t0 = std::clamp(glm::dot(from_centre, rect_.up) / glm::dot(rect_.up, rect_.up), -1.0, 1.0);
        double sum = 0;
        for (const Cell& cell : {Cell{-1, s0, -1, t0}, Cell{s0, 1, -1, t0}, Cell{-1, s0, t0, 1}, Cell{s0, 1, t0, 1}}) {
            if (cell.s1 - cell.s0 > 1e-9 && cell.t1 - cell.t0 > 1e-9) sum += refine(cell, gauss(cell), tolerance_ / 4, 0);
        }
        return sum;
    }

private:
    struct Cell {
        double s0, s1, t0, t1;
    };
    [[nodiscard]] dvec3 place(double s, double t) const { return rect_.centre + s * rect_.right + t * rect_.up - at_.p; }
    [[nodiscard]] double integrand(double s, double t) const
    {
        const dvec3 d = place(s, t);
        const double d2 = glm::dot(d, d);
        const dvec3 l = d / std::sqrt(d2);
        const double n_l = glm::dot(at_.n, l);
        if (n_l <= 0) return 0;
        const double n_v = std::max(glm::dot(at_.n, at_.v), 1e-4);
        const dvec3 f =
            brdf_twin(at_.base, at_.metallic, at_.roughness, at_.specular, n_v, n_l, glm::dot(at_.v, l));
        return f.x * n_l * -glm::dot(rect_.normal, l) / d2;
    }
    [[nodiscard]] double gauss(const Cell& c) const
    {
        static constexpr double x[]{0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640, -0.9061798459386640};
        static constexpr double w[]{0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891,
                                    0.2369268850561891};
        const double hs = 0.5 * (c.s1 - c.s0), ht = 0.5 * (c.t1 - c.t0), ms = 0.5 * (c.s0 + c.s1), mt = 0.5 * (c.t0 + c.t1);
        double sum = 0;
        for (int i = 0; i < 5; ++i) {
            for (int k = 0; k < 5; ++k) sum += w[i] * w[k] * integrand(ms + hs * x[i], mt + ht * x[k]);
        }
        return sum * hs * ht * glm::length(glm::cross(rect_.right, rect_.up));
    }
    /// Whether the lobe's width is small beside how the half vector turns within a cell that lies near the peak.
    [[nodiscard]] bool is_wide(const Cell& c) const
    {
        const double alpha = std::pow(std::max(at_.roughness, 0.045), 2);
        double least = 1e30, most = 0;
        for (int i = 0; i < 9; ++i) {
            const dvec3 d = place(glm::mix(c.s0, c.s1, 0.5 * (i % 3)), glm::mix(c.t0, c.t1, 0.5 * (i / 3)));
            const dvec3 h = glm::normalize(d) + at_.v;
            const double tangent = glm::length(glm::cross(h, at_.n)) / std::max(glm::dot(h, at_.n), 1e-6) / alpha;
            least = std::min(least, tangent);
            most = std::max(most, tangent);
        }
        return least < 100 && most - least > 2 * (1 + least);
    }
    [[nodiscard]] double refine(const Cell& c, double whole, double tolerance, int depth) const
    {
        const double ms = 0.5 * (c.s0 + c.s1), mt = 0.5 * (c.t0 + c.t1);
        const std::array<Cell, 4> parts{{{c.s0, ms, c.t0, mt}, {ms, c.s1, c.t0, mt}, {c.s0, ms, mt, c.t1}, {ms, c.s1, mt, c.t1}}};
        std::array<double, 4> sums{};
        double sum = 0;
        for (int i = 0; i < 4; ++i) sum += sums[i] = gauss(parts[i]);
        if (depth == 16 || (std::abs(sum - whole) < tolerance && !is_wide(c))) return sum;
        sum = 0;
        for (int i = 0; i < 4; ++i) sum += refine(parts[i], sums[i], tolerance / 2, depth + 1);
        return sum;
    }

    Point at_;
    Rect rect_;
    double tolerance_;
};

Rect rect_of(const Light& light)
{
    const LightAxes axes = axes_of(light);
    return {light.position, axes.right * (0.5f * light.width), axes.up * (0.5f * light.height), axes.direction};
}

/// A shape of one material; its specular part alone where `diffuse` is not asked for: a metal, or a black dielectric.
rig::FrameRig rig_of(const truth::Shape& shape, float metallic, float roughness, float specular, float base)
{
    truth::SceneBuilder builder;
    Material m;
    m.name = "surface";
    m.base_color = vec3(base);
    m.metallic = metallic;
    m.roughness = roughness;
    m.specular = specular;
    builder.add_mesh("shape", builder.add_material(m), shape);
    return rig::FrameRig(builder.finish());
}

/// Lights around the origin, which is seen from the side of +z, `elevation` degrees above the plane y = 0: each has its
/// mirror image in view.
std::vector<std::pair<std::string, std::string>> placements(float elevation)
{
    const float sine = std::sin(glm::radians(elevation)), cosine = std::cos(glm::radians(elevation));
    const auto mirrored = [&](float distance, float x) {
        return fmt::format("position={}:{}:{}", x, distance * sine, -distance * cosine);
    };
    const auto back = [&](float x, float y, float z) { return fmt::format(",direction={}:{}:{}", x, y - sine, z + cosine); };
    return {
        {"facing the origin", mirrored(1.5f, 0) + back(0, 0, 0) + ",width=1,height=1"},
        {"half below the horizon", "position=0:0.1:-1.5,direction=0:0:1,width=2,height=1.5"},
        {"a thin strip", mirrored(2, 0) + back(0, 0, 0) + fmt::format(",up=0:{}:{},width=0.05,height=6", cosine, sine)},
        {"close above", "position=0:0.3:-0.3,direction=0:-1:0,width=1,height=0.7"},
        {"far away", mirrored(60, 0) + back(0, 0, 0) + ",width=14,height=10"},
        {"askew", mirrored(2, 0.5f) + back(-0.8f, -0.6f, 0.5f) + ",up=1:1:0,width=1.6,height=0.8"},
        {"its plane crosses the view", "position=-0.5:0.6:-0.4,direction=0.2:0.1:1,width=1.5,height=1"},
    };
}

/// Largest error of the pixels of a frame, as share of the brightest pixel of brute force, and where it is.
struct Deviation {
    double of_peak = 0, peak = 0;
    double relative = 0; ///< largest of pixels that have a thousandth of the peak
};

Deviation deviation(const rig::FrameRig& rig, int stride)
{
    const std::vector<ImageF> got =
        rig.aovs({"light.0", "position", "normal", "albedo", "roughness", "metallic", "specular", "depth"});
    const Light& light = rig.request.lights.front();
    const Rect rect = rect_of(light);
    float brightest = 0;
    for (std::size_t i = 0; i < got[0].values.size(); i += 3) brightest = std::max(brightest, got[0].values[i]);
    const double tolerance = 3e-4 * brightest / light.radiance;

    struct Pixel {
        double want, got;
    };
    const int columns = got[0].width / stride, rows = got[0].height / stride;
    std::vector<Pixel> pixels(static_cast<std::size_t>(columns * rows), Pixel{0, 0});
    parallel_for(pixels.size(), [&](std::size_t i) {
        const int x = static_cast<int>(i) % columns * stride + stride / 2, y = static_cast<int>(i) / columns * stride + stride / 2;
        if (!std::isfinite(*got[7].at(x, y))) return;
        const auto vector = [&](std::size_t image) {
            const float* v = got[image].at(x, y);
            return dvec3(v[0], v[1], v[2]);
        };
        Point at{vector(1), glm::normalize(vector(2)), {}, vector(3), *got[5].at(x, y), *got[4].at(x, y), *got[6].at(x, y)};
        at.v = glm::normalize(dvec3(rig.request.camera.eye) - at.p);
        if (glm::dot(at.n, at.v) < 0.005) return; // a shading normal that looks away
        pixels[i] = {light.radiance * BruteForce(at, rect, tolerance).radiance(), *got[0].at(x, y)};
    });
    Deviation d;
    for (const Pixel& p : pixels) d.peak = std::max(d.peak, p.want);
    for (const Pixel& p : pixels) {
        d.of_peak = std::max(d.of_peak, std::abs(p.got - p.want) / d.peak);
        if (p.want > 1e-3 * d.peak) d.relative = std::max(d.relative, std::abs(p.got / p.want - 1));
    }
    return d;
}

void look_from(rig::FrameRig& rig, float elevation)
{
    const float a = glm::radians(elevation);
    rig.look({0, 4 * std::sin(a), 4 * std::cos(a)}, {0, 0, 0});
    rig.request.size = {48, 27};
    rig.set("ambient.intensity", "0");
}

TEST(area_light, specular_is_within_five_percent_of_the_peak)
{
    double worst = 0;
    for (const bool metal : {true, false}) {
        for (const float roughness : {0.0f, 0.15f, 0.3f, 0.5f, 0.75f, 1.0f}) {
            rig::FrameRig rig = rig_of(truth::ground(200), metal, roughness, 0.04f, metal ? 0.9f : 0.0f);
            for (const float elevation : {70.0f, 30.0f, 8.0f}) {
                look_from(rig, elevation);
                for (const auto& [name, spec] : placements(elevation)) {
                    rig.request.lights.clear();
                    rig.light("rect,radiance=10," + spec);
                    const Deviation d = deviation(rig, 1);
                    worst = std::max(worst, d.of_peak);
                    EXPECT_LT(d.of_peak, 0.05) << (metal ? "metal" : "dielectric") << " of roughness " << roughness << ", "
                                               << name << ", from " << elevation << " degrees";
                    if (std::getenv("LTC_PRINT")) std::printf("%d %.3f %2.0f %-28s peak %8.4f err %.4f rel %.3f\n", metal, roughness, elevation, name.c_str(), d.peak, d.of_peak, d.relative);
                    EXPECT_GT(d.peak, 1e-3) << name;
                }
            }
        }
    }
    RecordProperty("worst", fmt::format("{}", worst));
    std::printf("worst %f\n", worst);
}

TEST(area_light, diffuse_is_within_one_percent)
{
    rig::FrameRig rig = rig_of(truth::ground(200), 0, 1, 0, 0.5f);
    for (const float elevation : {70.0f, 30.0f, 8.0f}) {
        look_from(rig, elevation);
        for (const auto& [name, spec] : placements(elevation)) {
            rig.request.lights.clear();
            rig.light("rect,radiance=10," + spec);
            const Deviation d = deviation(rig, 1);
            std::printf("diffuse %-28s %2.0f peak %.4f rel %.5f of peak %.5f\n", name.c_str(), elevation, d.peak, d.relative, d.of_peak);
            EXPECT_LT(d.relative, 0.01) << name << ", from " << elevation << " degrees";
        }
    }
}

} // namespace
} // namespace atrium
