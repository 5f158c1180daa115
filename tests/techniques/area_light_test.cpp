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
        const double s0 =
            std::clamp(glm::dot(from_centre, rect_.right) / glm::dot(rect_.right, rect_.right), -1.0, 1.0);
        const double t0 = std::clamp(glm::dot(from_centre, rect_.up) / glm::dot(rect_.up, rect_.up), -1.0, 1.0);
        double sum = 0;
        for (const Cell& cell : {Cell{-1, s0, -1, t0}, Cell{s0, 1, -1, t0}, Cell{-1, s0, t0, 1}, Cell{s0, 1, t0, 1}}) {
            if (cell.s1 - cell.s0 > 1e-9 && cell.t1 - cell.t0 > 1e-9)
                sum += refine(cell, gauss(cell), tolerance_ / 4, 0);
        }
        return sum;
    }

private:
    struct Cell {
        double s0, s1, t0, t1;
    };
    [[nodiscard]] dvec3 place(double s, double t) const
    {
        return rect_.centre + s * rect_.right + t * rect_.up - at_.p;
    }
    [[nodiscard]] double integrand(double s, double t) const
    {
        const dvec3 d = place(s, t);
        const double d2 = glm::dot(d, d);
        const dvec3 l = d / std::sqrt(d2);
        const double n_l = glm::dot(at_.n, l);
        if (n_l <= 0) return 0;
        const double n_v = std::max(glm::dot(at_.n, at_.v), 1e-4);
        const dvec3 f = brdf_twin(at_.base, at_.metallic, at_.roughness, at_.specular, n_v, n_l, glm::dot(at_.v, l));
        return f.x * n_l * -glm::dot(rect_.normal, l) / d2;
    }
    [[nodiscard]] double gauss(const Cell& c) const
    {
        static constexpr double x[]{0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                                    -0.9061798459386640};
        static constexpr double w[]{0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891,
                                    0.2369268850561891};
        const double hs = 0.5 * (c.s1 - c.s0), ht = 0.5 * (c.t1 - c.t0), ms = 0.5 * (c.s0 + c.s1),
                     mt = 0.5 * (c.t0 + c.t1);
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
        const std::array<Cell, 4> parts{
            {{c.s0, ms, c.t0, mt}, {ms, c.s1, c.t0, mt}, {c.s0, ms, mt, c.t1}, {ms, c.s1, mt, c.t1}}};
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

/// A shape of one material, under no light but those that a test adds.
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
    const auto back = [&](float x, float y, float z) {
        return fmt::format(",direction={}:{}:{}", x, y - sine, z + cosine);
    };
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

Deviation deviation(const rig::FrameRig& rig)
{
    const std::vector<ImageF> got =
        rig.aovs({"light.0", "position", "normal", "albedo", "roughness", "metallic", "specular", "depth"});
    const Light& light = rig.request.lights.front();
    const Rect rect = rect_of(light);
    float brightest = 0;
    for (std::size_t i = 0; i < got[0].values.size(); i += 3) brightest = std::max(brightest, got[0].values[i]);
    const double tolerance = std::max(3e-4f * brightest / light.radiance, 1e-7f);

    struct Pixel {
        double want, got;
    };
    std::vector<Pixel> pixels(got[0].values.size() / 3, Pixel{0, 0});
    parallel_for(pixels.size(), [&](std::size_t i) {
        const int x = static_cast<int>(i) % got[0].width, y = static_cast<int>(i) / got[0].width;
        if (!std::isfinite(*got[7].at(x, y))) return;
        const auto vector = [&](std::size_t image) {
            const float* v = got[image].at(x, y);
            return dvec3(v[0], v[1], v[2]);
        };
        Point at{vector(1),        glm::normalize(vector(2)), {}, vector(3), *got[5].at(x, y),
                 *got[4].at(x, y), *got[6].at(x, y)};
        at.v = glm::normalize(dvec3(rig.request.camera.eye) - at.p);
        if (glm::dot(at.n, at.v) < 0.005) return; // a shading normal that looks away
        pixels[i] = {light.radiance * BruteForce(at, rect, tolerance).radiance(), *got[0].at(x, y)};
    });
    Deviation d;
    for (const Pixel& p : pixels) d.peak = std::max(d.peak, p.want);
    EXPECT_GT(d.peak, 0) << "nothing is lit";
    for (const Pixel& p : pixels) {
        EXPECT_TRUE(std::isfinite(p.got));
        d.of_peak = std::max(d.of_peak, std::abs(p.got - p.want) / d.peak);
        if (p.want > 1e-3 * d.peak) d.relative = std::max(d.relative, std::abs(p.got / p.want - 1));
    }
    return d;
}

void look_from(rig::FrameRig& rig, float elevation)
{
    const float a = glm::radians(elevation);
    rig.look({0, 4 * std::sin(a), 4 * std::cos(a)}, {0, 0, 0});
    rig.request.size = {32, 18};
    rig.set("ambient.intensity", "0");
}

Deviation deviation(rig::FrameRig& rig, const std::string& rect)
{
    rig.request.lights.clear();
    rig.light("rect,radiance=10," + rect);
    return deviation(rig);
}

TEST(area_light, specular_is_within_five_percent_of_the_peak)
{
    // Measured: 2.9 %; with cosines alone, not mended by the BRDF, up to 80 %.
    double worst = 0;
    for (const bool metal : {true, false}) {
        for (const float roughness : {0.0f, 0.15f, 0.3f, 0.5f, 0.75f, 1.0f}) {
            rig::FrameRig rig = rig_of(truth::ground(200), metal, roughness, 0.04f, metal ? 0.9f : 0.0f);
            for (const float elevation : {70.0f, 30.0f, 8.0f}) {
                look_from(rig, elevation);
                for (const auto& [name, rect] : placements(elevation)) {
                    const Deviation d = deviation(rig, rect);
                    worst = std::max(worst, d.of_peak);
                    EXPECT_LT(d.of_peak, 0.05) << (metal ? "metal" : "dielectric") << " of roughness " << roughness
                                               << ", " << name << ", from " << elevation << " degrees";
                }
            }
        }
    }
    RecordProperty("largest_share_of_peak", fmt::format("{:.4f}", worst));
}

TEST(area_light, highlights_on_a_sphere_are_within_five_percent_of_the_peak)
{
    // Normals that are no axis, every angle to the eye. Measured: 0.9 %.
    for (const float roughness : {0.1f, 0.4f, 0.8f}) {
        rig::FrameRig rig = rig_of(truth::sphere({0, 0, 0}, 1.5f, 128), 0, roughness, 0.08f, 0);
        look_from(rig, 20);
        for (const char* rect : {"position=3:3:2,direction=-1:-1:-0.7,width=2,height=1",
                                 "position=-4:0:-3,direction=1:0:0.6,width=1,height=5",
                                 "position=0:2.5:0,direction=0:-1:0,width=3,height=3"}) {
            const Deviation d = deviation(rig, rect);
            EXPECT_LT(d.of_peak, 0.05) << "roughness " << roughness << ", " << rect;
        }
    }
}

TEST(area_light, diffuse_is_within_one_percent)
{
    // Measured: 0.4 %, and that beside the horizon, where the brute force is no better.
    rig::FrameRig rig = rig_of(truth::ground(200), 0, 1, 0, 0.5f);
    for (const float elevation : {70.0f, 30.0f, 8.0f}) {
        look_from(rig, elevation);
        for (const auto& [name, rect] : placements(elevation)) {
            EXPECT_LT(deviation(rig, rect).relative, 0.01) << name << ", from " << elevation << " degrees";
        }
    }
}

TEST(area_light, a_small_far_one_keeps_its_digits)
{
    // 10 cm at 290 m: what the four edges give cancels but for a few thousandths.
    rig::FrameRig rig = rig_of(truth::ground(200), 0, 1, 0, 0.5f);
    look_from(rig, 70);
    EXPECT_LT(deviation(rig, "position=90:270:60,direction=-3:-9:-2,width=0.1,height=0.1").relative, 0.01);
}

TEST(area_light, diffuse_and_specular_add_up)
{
    rig::FrameRig rig = rig_of(truth::ground(200), 0.3f, 0.6f, 0.04f, 0.7f);
    look_from(rig, 30);
    EXPECT_LT(deviation(rig, placements(30).front().second).relative, 0.02);
}

TEST(area_light, the_table_is_what_the_program_makes)
{
    for (const auto& [row, column] :
         {std::pair{0u, 31u}, {0u, 8u}, {5u, 5u}, {12u, 0u}, {15u, 16u}, {31u, 20u}, {31u, 31u}}) {
        const shared::LtcEntry made = fit_ltc(ltc_roughness(row), ltc_cosine(column));
        const shared::LtcEntry kept = ltc_table()[row * shared::ltc_size + column];
        const auto same = [&, row = row, column = column](float a, float b) {
            EXPECT_NEAR(a, b, 1e-3f * (1 + std::abs(b))) << row << ", " << column;
        };
        same(made.log2_along, kept.log2_along);
        same(made.log2_across, kept.log2_across);
        same(made.skew, kept.skew);
        same(made.albedo, kept.albedo);
        same(made.fresnel, kept.fresnel);
    }
}

} // namespace
} // namespace atrium
