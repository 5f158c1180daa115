// Ambient occlusion against closed forms and against rays.

#include "tests/rig/frame_rig.hpp"
#include "tests/truth/closed_forms.hpp"
#include "tests/truth/primary.hpp"
#include "tests/truth/shapes.hpp"
#include "tests/truth/visibility.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

using glm::dvec2;
using glm::dvec3;

/// What SSAO's uniform samples make of a wall at k radii.
double ssao_beside_wall(double k)
{
    return k >= 1 ? 1 : 1 - (2 + k) * (1 - k) * (1 - k) / 4;
}

void set_ao(rig::FrameRig& rig, const std::string& method, float radius)
{
    rig.request.size = {640, 360};
    rig.set("ao.method", method);
    rig.set("ao.radius", std::to_string(radius));
    rig.set("ao.falloff", "0");
    rig.set("ao.samples", "18");
}

/// Mean AO, and what it ought to be there, over the floor's pixels around a point (x and z within `reach`).
struct Patch {
    double ao = 0, expected = 0;
    int pixels = 0;
};

template <class Expected>
Patch patch_around(const std::vector<ImageF>& position_and_ao, const dvec2& at, double reach, Expected expected)
{
    Patch patch;
    const ImageF &positions = position_and_ao[0], &ao = position_and_ao[1];
    for (int y = 0; y < ao.height; ++y) {
        for (int x = 0; x < ao.width; ++x) {
            const float* p = positions.at(x, y);
            const bool background = p[0] == 0 && p[1] == 0 && p[2] == 0;
            if (background || std::abs(p[1]) > 1e-3f || std::abs(p[0] - at.x) > reach || std::abs(p[2] - at.y) > reach)
                continue;
            patch.ao += *ao.at(x, y);
            patch.expected += expected(p[0], p[2]);
            ++patch.pixels;
        }
    }
    patch.ao /= patch.pixels;
    patch.expected /= patch.pixels;
    return patch;
}

void expect_near(const Patch& patch, const std::string& what)
{
    ASSERT_GT(patch.pixels, 20) << what;
    EXPECT_NEAR(patch.ao, patch.expected, 0.05) << what;
}

int count_passes(const FrameResult& frame, const std::string& name)
{
    const std::vector<graph::PassStats>& passes = frame.stats.passes;
    return static_cast<int>(
        std::count_if(passes.begin(), passes.end(), [&](const graph::PassStats& p) { return p.name == name; }));
}

TEST(ao, a_lone_plane_is_open_at_any_angle)
{
    rig::FrameRig rig(truth::floor_scene());
    for (const char* method : {"ssao", "gtao"}) {
        set_ao(rig, method, 0.5f);
        rig.request.size = {641, 361}; // the last half-size texels stand for pixels with no neighbour
        for (const char* half : {"off", "on"}) {
            rig.set("ao.half_resolution", half);
            for (const float height : {0.2f, 0.5f, 1.0f, 3.0f, 10.0f}) {
                rig.look({0, height, 3}, {0.3f, 0, 0}, 50);
                const std::vector<ImageF> got = rig.aovs({"ao", "material"});
                float least = 1;
                int floor = 0;
                for (std::size_t i = 0; i < got[0].values.size(); ++i) {
                    if (got[1].values[i] < 0) continue;
                    least = std::min(least, got[0].values[i]);
                    ++floor;
                }
                EXPECT_GT(floor, 50'000) << "from " << height;
                EXPECT_GE(least, 0.98f) << method << " at half size: " << half << ", from " << height;
            }
            rig.request.aovs = {parse_aov("ao", {})}; // or it would be open because nothing looked
            EXPECT_EQ(count_passes(rig.render(), "ao"), 1) << method << " at half size: " << half;
            rig.request.aovs.clear();
        }
    }
}

TEST(ao, beside_a_wall_it_has_the_closed_form)
{
    rig::FrameRig rig(truth::wall_and_floor());
    for (const float radius : {0.5f, 1.0f}) {
        for (const vec3& eye : {vec3(3, 2.5f, 0.7f), vec3(2, 3, -2)}) {
            rig.look(eye, {0.4f, 0, 0}, 60);
            for (const double k : {0.1, 0.25, 0.5, 0.75, 0.9}) {
                const dvec2 at(k * radius, 0);
                set_ao(rig, "gtao", radius);
                expect_near(patch_around(rig.aovs({"position", "ao"}), at, 0.04,
                                         [&](double x, double) { return 1 - truth::beyond_chord(x / radius); }),
                            "gtao at " + std::to_string(k));
                set_ao(rig, "ssao", radius);
                expect_near(patch_around(rig.aovs({"position", "ao"}), at, 0.04,
                                         [&](double x, double) { return ssao_beside_wall(x / radius); }),
                            "ssao at " + std::to_string(k));
            }
        }
    }
}

TEST(ao, in_a_corner_it_has_the_closed_form)
{
    rig::FrameRig rig(truth::corner_scene());
    set_ao(rig, "gtao", 1);
    for (const vec3& eye : {vec3(2.2f, 2.4f, 2.6f), vec3(2, 0.9f, 1.4f), vec3(1.5f, 4, 1.5f)}) {
        rig.look(eye, {0.3f, 0.1f, 0.3f}, 60);
        for (const double k : {0.1, 0.25, 0.5}) {
            expect_near(patch_around(rig.aovs({"position", "ao"}), dvec2(k), 0.04,
                                     [](double x, double z) {
                                         return 1 - truth::beyond_chord(x) - truth::beyond_chord(z) +
                                                truth::beyond_both(x, z);
                                     }),
                        "corner at " + std::to_string(k));
        }
    }
}

TEST(ao, beside_a_sphere_it_has_the_closed_form)
{
    rig::FrameRig rig(truth::sphere_on_floor(1));
    set_ao(rig, "gtao", 50);
    for (const vec3& eye : {vec3(4, 3.5f, 4), vec3(5, 2, 5), vec3(3.5f, 6, 3.5f), vec3(0, 3.5f, 6)}) {
        rig.look(eye, {0, 0.5f, 0}, 60);
        for (const double d : {0.5, 1.0, 2.0}) {
            const double s = d / std::sqrt(2.0);
            expect_near(patch_around(rig.aovs({"position", "ao"}), dvec2(s, s), 0.1,
                                     [](double x, double z) { return 1 - std::pow(1 + x * x + z * z, -1.5); }),
                        "sphere at " + std::to_string(d));
        }
    }
}

TEST(ao, under_a_low_ceiling_it_has_the_closed_form)
{
    rig::FrameRig rig(truth::ceiling_scene(0.5f));
    // From between the two: all of the ceiling within the radius is in the picture.
    for (const vec3& eye : {vec3(0, 0.25f, 3), vec3(0, 0.1f, 3), vec3(1.5f, 0.3f, 2.5f), vec3(-1, 0.35f, 2.5f)}) {
        rig.look(eye, {0, 0.25f, 0}, 60);
        for (const double k : {0.25, 0.5, 0.75, 0.9}) {
            set_ao(rig, "gtao", static_cast<float>(0.5 / k));
            expect_near(
                patch_around(rig.aovs({"position", "ao"}), dvec2(0), 0.2, [&](double, double) { return k * k; }),
                "ceiling at " + std::to_string(k));
        }
    }
}

double mean(const ImageF& image)
{
    double sum = 0;
    for (const float value : image.values) sum += value;
    return sum / static_cast<double>(image.values.size());
}

TEST(ao, each_setting_does_what_it_says)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.size = {640, 360};
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    rig.set("ao.method", "off");
    EXPECT_EQ(mean(rig.aov("ao")), 1);
    const double open = mean(rig.aov("ambient"));
    set_ao(rig, "gtao", 0.5f);
    const double ao = mean(rig.aov("ao")), lit = mean(rig.aov("ambient"));
    EXPECT_LT(ao, 0.95);
    EXPECT_LT(lit, open);
    const auto with = [&](const char* key, const char* value, const char* aov) {
        rig.set(key, value);
        return mean(rig.aov(aov));
    };
    EXPECT_GT(with("ao.multi_bounce", "on", "ambient"), 1.001 * lit);
    rig.set("ao.multi_bounce", "off");
    EXPECT_GT(with("ao.thin", "4", "ao"), ao + 0.002);
    rig.set("ao.thin", "0");
    EXPECT_GT(with("ao.falloff", "1", "ao"), ao + 0.002);
    rig.set("ao.falloff", "0");
    EXPECT_LT(with("ao.power", "2", "ao"), ao - 0.002);
    rig.set("ao.power", "1");
    EXPECT_LT(with("ao.radius", "1", "ao"), ao - 0.002);
    rig.set("ao.radius", "0.5");
    rig.set("ao.blur", "off");
    const ImageF raw = rig.aov("ao_raw"), unblurred = rig.aov("ao");
    EXPECT_EQ(raw.values, unblurred.values);
    rig.set("ao.blur", "on");
    EXPECT_NE(rig.aov("ao").values, raw.values);
}

TEST(ao, touches_ambient_light_only)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.light("sun");
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    rig.set("ao.method", "off");
    const std::vector<ImageF> without = rig.aovs({"light.0", "ambient"});
    EXPECT_GT(mean(without[0]), 0.01);
    set_ao(rig, "ssao", 0.5f);
    rig.request.size = {320, 180};
    const std::vector<ImageF> with = rig.aovs({"light.0", "ambient"});
    EXPECT_EQ(with[0].values, without[0].values);
    EXPECT_LT(mean(with[1]), 0.99 * mean(without[1]));
}

/// RMSE of `ao` against rays, where silhouettes and what lies off the screen do not matter.
double rmse(const ImageF& ao, const ImageF& truth, const truth::Mask& counts)
{
    double sum = 0, pixels = 0;
    for (std::size_t i = 0; i < ao.values.size(); ++i) {
        if (!counts.values[i]) continue;
        const double d = ao.values[i] - truth.values[i];
        sum += d * d;
        ++pixels;
    }
    return std::sqrt(sum / pixels);
}

ImageF traced_ao(const truth::TruthScene& scene, const truth::PrimaryBuffers& seen, double radius)
{
    ImageF out(seen.depth.width, seen.depth.height, 1);
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            float* to = &out.values[seen.surface.index(x, y)];
            *to = 1;
            if (!seen.surface.at(x, y)) continue;
            const float *p = seen.position.at(x, y), *n = seen.geometric_normal.at(x, y);
            *to = static_cast<float>(truth::ambient_visibility(
                scene, {dvec3(p[0], p[1], p[2]), dvec3(n[0], n[1], n[2])}, radius, {256, seen.surface.index(x, y)}));
        }
    }
    return out;
}

/// Both methods, and gtao at half resolution and with few samples, against rays of the same radius.
void expect_near_to_rays(rig::FrameRig& rig, const truth::TruthScene& scene, const vec3& eye, const vec3& target)
{
    const ivec2 size{320, 180};
    rig.look(eye, target, 60);
    const truth::PrimaryBuffers seen = truth::cast_primary(scene, rig.request.camera, size, 0.01);
    const truth::Mask counts = truth::without(seen.surface, truth::silhouettes(seen));
    const ImageF truth = traced_ao(scene, seen, 0.5);
    const auto error = [&](const char* method, const char* samples, const char* half) {
        set_ao(rig, method, 0.5f);
        rig.request.size = size;
        rig.set("ao.samples", samples);
        rig.set("ao.half_resolution", half);
        return rmse(rig.aov("ao"), truth, counts);
    };
    const double gtao = error("gtao", "18", "off"), ssao = error("ssao", "18", "off");
    EXPECT_LE(gtao, 0.10);
    EXPECT_LT(gtao, ssao);
    EXPECT_LE(error("gtao", "18", "on"), 1.2 * gtao);
    EXPECT_LE(error("gtao", "8", "off"), 0.10);
}

TEST(ao, of_the_courtyard_is_near_to_what_rays_say)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.set("debug.alpha_lod0", "on");
    const truth::TruthScene scene(rig.bake());
    expect_near_to_rays(rig, scene, {-7.9f, 1.75f, 1.55f}, {3.4f, 3.75f, -1.3f});
    expect_near_to_rays(rig, scene, {-4.3f, 1.6f, 0.5f}, {0.6f, 1.3f, -0.45f});
}

TEST(ao, of_sponza_is_near_to_what_rays_say)
{
    const auto bake = rig::sponza_bake();
    if (!bake) GTEST_SKIP() << "ATRIUM_SCENES names no folder of real scenes";
    rig::FrameRig rig(*bake);
    rig.set("debug.alpha_lod0", "on");
    const truth::TruthScene scene(rig.bake());
    expect_near_to_rays(rig, scene, {-11.5f, 1.7f, -0.4f}, {10, 3.5f, -0.4f});
    expect_near_to_rays(rig, scene, {-12.5f, 6, 4.6f}, {8, 5.5f, -2});
}

} // namespace
} // namespace atrium
