// Shadows against closed forms and against rays.

#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shadow_truth.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace atrium {
namespace {

void set_filter(rig::FrameRig& rig, const std::string& filter, int resolution = 2048)
{
    rig.set("shadow.filter", filter);
    rig.set("shadow.resolution", std::to_string(resolution));
    rig.set("shadow.samples", "32");
    rig.set("shadow.blocker_samples", "16");
    rig.set("debug.alpha_lod0", "on");
}

std::string at(const vec3& p)
{
    return std::to_string(p.x) + ":" + std::to_string(p.y) + ":" + std::to_string(p.z);
}

/// Names of the passes that draw maps.
std::vector<std::string> map_passes(const FrameResult& frame)
{
    std::vector<std::string> out;
    for (const graph::PassStats& pass : frame.stats.passes) {
        if (pass.name.starts_with("shadow.") && pass.name.find('.', 7) == std::string::npos) out.push_back(pass.name);
    }
    return out;
}

/// Pixels of a plane that a light must not darken, and those that it does.
struct PlanePixels {
    int tested = 0, dark = 0;
};

/// `to_light`: of a sun, else none. What is not the plane has no material.
PlanePixels find_dark(const ImageF& positions, const ImageF& materials, const ImageF& visibility, const vec3& light,
                      std::optional<vec3> to_light)
{
    PlanePixels out;
    for (int y = 0; y < positions.height; ++y) {
        for (int x = 0; x < positions.width; ++x) {
            if (*materials.at(x, y) < 0) continue;
            const float* p = positions.at(x, y);
            const vec3 d = light - vec3(p[0], p[1], p[2]);
            const float cosine = to_light ? to_light->y : d.y / glm::length(d);
            if (cosine <= 0.17f) continue; // a disc that dips below the plane is seen in part
            ++out.tested;
            out.dark += *visibility.at(x, y) < 1 ? 1 : 0;
        }
    }
    return out;
}

TEST(shadow, a_lone_plane_has_none_at_any_slope)
{
    rig::FrameRig rig(truth::floor_scene());
    rig.look({0, 3, 4}, {0, 0, 0});
    rig.set("shadow.cache", "off"); // so that every frame draws the maps
    for (const int degrees : {0, 20, 40, 60, 70, 80}) {
        const float a = glm::radians(static_cast<float>(degrees));
        const vec3 to_light(std::sin(a) * 0.6f, std::cos(a), std::sin(a) * 0.8f);
        rig.request.lights.clear();
        rig.light("spot,position=" + at(5.0f * to_light) + ",direction=" + at(-to_light) + ",outer=25,size=0.3");
        rig.light("point,position=" + at(3.0f * to_light) + ",size=0.3");
        rig.light("sun,angle=2,direction=" + at(-to_light));
        rig.light("rect,position=" + at(4.0f * to_light) + ",direction=" + at(-to_light));
        for (const char* filter : {"hard", "pcf", "pcss"}) {
            for (const int resolution : {512, 2048}) {
                set_filter(rig, filter, resolution);
                rig.request.aovs.clear();
                for (const char* name :
                     {"position", "material", "visibility.0", "visibility.1", "visibility.2", "visibility.3"})
                    rig.request.aovs.push_back(parse_aov(name, rig.request.lights));
                const FrameResult frame = rig.render();
                EXPECT_EQ(map_passes(frame).size(), 4u) << "or nothing could have been darkened";
                for (std::size_t light = 0; light < 4; ++light) {
                    const PlanePixels found = find_dark(frame.aovs[0], frame.aovs[1], frame.aovs[2 + light],
                                                        rig.request.lights[light].position,
                                                        light == 2 ? std::optional(to_light) : std::nullopt);
                    const std::string what = std::string(filter) + " at " + std::to_string(degrees) + ", light " +
                                             std::to_string(light) + ", " + std::to_string(resolution);
                    EXPECT_GT(found.tested, 1000) << what;
                    EXPECT_EQ(found.dark, 0) << what;
                }
            }
        }
    }
}

TEST(shadow, a_box_s_shadow_stays_attached)
{
    rig::FrameRig rig(truth::box_on_floor(0.5f));
    rig.request.size = {640, 360};
    rig.look({2.2f, 0.8f, 0.8f}, {0.6f, 0, 0}, 40);
    rig.light("spot,position=-3:4:0,direction=3.2:-4:0,outer=30,size=0.2");
    const float texel = 2 * 5.1f * std::tan(glm::radians(33.0f)) / 2048; // m, at the box's foot
    for (const auto& [filter, texels] : {std::pair{"hard", 1.5f}, {"pcss", 4.0f}}) {
        set_filter(rig, filter);
        const std::vector<ImageF> got = rig.aovs({"position", "visibility.0"});
        float gap = 0;
        int pixels = 0;
        for (int y = 0; y < 360; ++y) {
            for (int x = 0; x < 640; ++x) {
                const float* p = got[0].at(x, y);
                const bool beside = std::abs(p[1]) < 1e-3f && p[0] > 0.5f && p[0] < 0.8f && std::abs(p[2]) < 0.3f;
                if (!beside) continue;
                ++pixels;
                if (*got[1].at(x, y) > 0.5f) gap = std::max(gap, p[0] - 0.5f);
            }
        }
        EXPECT_GT(pixels, 1000);
        EXPECT_LE(gap, texels * texel) << filter;
    }
}

/// Mean visibility by x over the floor near z = 0, in steps of `width` / 40 around the edge's shadow in x = 0.
struct Profile {
    std::vector<double> x, v;

    [[nodiscard]] double where(double visibility) const
    {
        for (std::size_t i = 1; i < v.size(); ++i) {
            if ((v[i - 1] - visibility) * (v[i] - visibility) <= 0 && v[i] != v[i - 1])
                return x[i - 1] + (x[i] - x[i - 1]) * (visibility - v[i - 1]) / (v[i] - v[i - 1]);
        }
        return 1e9;
    }
};

Profile profile_of(const ImageF& positions, const ImageF& visibility, double width)
{
    constexpr int bins = 80;
    std::vector<double> sum(bins), count(bins);
    for (int y = 0; y < positions.height; ++y) {
        for (int x = 0; x < positions.width; ++x) {
            const float* p = positions.at(x, y);
            if (std::abs(p[1]) > 1e-3f || std::abs(p[2]) > 0.5f) continue;
            const auto bin =
                static_cast<int>(std::floor(static_cast<double>(p[0]) / width * (bins / 2.0) + bins / 2.0));
            if (bin < 0 || bin >= bins) continue;
            sum[static_cast<std::size_t>(bin)] += static_cast<double>(*visibility.at(x, y));
            count[static_cast<std::size_t>(bin)] += 1;
        }
    }
    Profile out;
    for (int i = 0; i < bins; ++i) {
        if (count[static_cast<std::size_t>(i)] < 1) continue;
        out.x.push_back((i + 0.5 - bins / 2.0) * width / (bins / 2.0));
        out.v.push_back(sum[static_cast<std::size_t>(i)] / count[static_cast<std::size_t>(i)]);
    }
    return out;
}

TEST(shadow, an_edge_s_penumbra_has_the_width_of_the_closed_form)
{
    constexpr float height = 4; // of lights
    int compared = 0;
    for (const float ratio : {0.3f, 0.5f, 0.7f, 0.9f}) {
        rig::FrameRig rig(truth::plate_over_floor(height * (1 - ratio)));
        rig.request.size = {640, 360};
        set_filter(rig, "pcss");
        for (const float texels : {8.0f, 24.0f, 80.0f, 256.0f}) {
            // Widths of the whole penumbra on the map, and the light that makes them.
            const float tangent = std::tan(glm::radians(40.0f)) + 0.1f;
            const float width = texels * 2 * height * tangent / 2048;
            const float size = 0.5f * width * ratio / (1 - ratio);
            if (size > 1) continue;
            const float away = std::clamp(4 * width, 0.1f, 1.2f); // near enough for many pixels in a narrow one
            rig.look({-away, 0.2f * away, 0}, {0.1f * away, 0, 0}, 70);
            const std::string square = std::to_string(2 * size);
            const std::pair<std::string, double> lights[]{
                {"spot,position=0:4:0,outer=40,size=" + std::to_string(size), 0.687},
                {"rect,position=0:4:0,width=" + square + ",height=" + square, 0.8}};
            for (const auto& [light, share] : lights) {
                rig.request.lights.clear();
                rig.light(light);
                const std::vector<ImageF> got = rig.aovs({"position", "visibility.0"});
                const Profile profile = profile_of(got[0], got[1], static_cast<double>(width));
                const double reached = std::abs(profile.where(0.9) - profile.where(0.1));
                EXPECT_NEAR(reached / (share * static_cast<double>(width)), 1, 0.1) << light << ", " << ratio;
                ++compared;
            }
        }
    }
    EXPECT_GE(compared, 20);
}

/// Errors of filters against rays for the rig's one light.
class AgainstRays {
public:
    AgainstRays(rig::FrameRig& rig, int count)
        : rig_(rig), scene_(rig.bake()),
          primary_(truth::cast_primary(scene_, rig.request.camera, ivec2(rig.request.size))),
          truth_(truth::cast_visibility(scene_, primary_, rig.request.lights.front(), count)),
          mask_(truth::lit_pixels(primary_, rig.request.lights.front()))
    {}
    [[nodiscard]] truth::VisibilityError error() const
    {
        return truth::compare_visibility(truth_, rig_.aov("visibility.0"), mask_);
    }
    /// The least penumbra error of 48 comparisons over a disc of one size.
    [[nodiscard]] double best_pcf() const
    {
        rig_.set("shadow.filter", "pcf");
        rig_.set("shadow.samples", "48");
        double best = 1;
        for (const int radius : {3, 6, 9, 10, 16, 20, 24, 28, 32, 36, 44, 54}) {
            rig_.set("shadow.radius", std::to_string(radius));
            best = std::min(best, error().penumbra_rmse);
        }
        return best;
    }

private:
    rig::FrameRig& rig_;
    truth::TruthScene scene_;
    truth::PrimaryBuffers primary_;
    ImageF truth_;
    truth::Mask mask_;
};

void expect_hard_like_rays(rig::FrameRig& rig, const std::string& light, double bound)
{
    rig.request.lights.clear();
    rig.light(light);
    set_filter(rig, "hard");
    const truth::VisibilityError e = AgainstRays(rig, 1).error();
    EXPECT_LE(e.wrong, bound) << light;
    EXPECT_GT(e.share, 0.03) << light;
}

TEST(shadow, hard_ones_are_where_rays_say)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.size = {640, 360};
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    expect_hard_like_rays(rig, "sun,direction=0.35:-1:0.25", 0.015);
    expect_hard_like_rays(rig, "spot,position=0:5:0,direction=-0.4:-1:0.2,outer=50,inner=30", 0.015);
    expect_hard_like_rays(rig, "point,position=1:2.5:0.5", 0.015);
    expect_hard_like_rays(rig, "rect,position=1:4:0.5,direction=-0.3:-1:0", 0.015);
}

TEST(shadow, hard_ones_are_where_rays_say_in_sponza)
{
    const auto bake = rig::sponza_bake();
    if (!bake) GTEST_SKIP() << "ATRIUM_SCENES names no folder of real scenes";
    rig::FrameRig rig(*bake);
    rig.request.size = {640, 360};
    rig.look({-11.5f, 1.7f, -0.4f}, {10, 3.5f, -0.4f});
    expect_hard_like_rays(rig, "sun,direction=0.35:-1:0.25", 0.02);
    expect_hard_like_rays(rig, "spot,position=0:6:-0.4,direction=-0.5:-1:0.3,outer=45,inner=30", 0.02);
    expect_hard_like_rays(rig, "point,position=-3:3:-0.4", 0.02);
}

void expect_softer_than_one_size(rig::FrameRig& rig, const std::string& light, double share, int count = 256)
{
    rig.request.lights.clear();
    rig.light(light);
    const AgainstRays rays(rig, count);
    set_filter(rig, "pcss");
    const double pcss = rays.error().penumbra_rmse;
    const double pcf = rays.best_pcf();
    EXPECT_LE(pcss, share * pcf) << light << ": pcss " << pcss << ", pcf " << pcf;
}

/// A wall that stands on the floor and ends at z = 0: its shadow begins sharp at the foot and softens with distance.
BakeData wall_with_an_end()
{
    truth::SceneBuilder builder;
    const std::uint32_t grey = builder.add_material("floor"), white = builder.add_material("wall");
    builder.add_mesh("floor", grey, truth::ground(20));
    builder.add_mesh("wall", white, truth::box({-0.05f, 0, -6}, {0.05f, 2.5f, 0}));
    return builder.finish();
}

TEST(shadow, pcss_is_nearer_to_rays_than_any_disc_of_one_size)
{
    {
        rig::FrameRig rig(wall_with_an_end());
        rig.look({3.2f, 1.6f, 2.0f}, {1.2f, 0, -0.6f}, 60);
        expect_softer_than_one_size(rig, "spot,position=-2:4:-0.5,direction=1.5:-2.2:0,outer=40,size=0.3", 0.6, 1024);
    }
    rig::FrameRig rig(rig::courtyard_bake());
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    expect_softer_than_one_size(rig, "spot,position=0:5:0,direction=-0.4:-1:0.2,outer=50,inner=30,size=0.3", 0.6);
    expect_softer_than_one_size(rig, "point,position=1:2.5:0.5,size=0.2", 0.6);
}

TEST(shadow, pcss_is_nearer_to_rays_than_any_disc_of_one_size_in_sponza)
{
    const auto bake = rig::sponza_bake();
    if (!bake) GTEST_SKIP() << "ATRIUM_SCENES names no folder of real scenes";
    rig::FrameRig rig(*bake);
    rig.look({-11.5f, 1.7f, -0.4f}, {10, 3.5f, -0.4f});
    expect_softer_than_one_size(rig, "spot,position=0:6:-0.4,direction=-0.5:-1:0.3,outer=45,inner=30,size=0.3", 0.75);
    expect_softer_than_one_size(rig, "point,position=-6:3:0.5,size=0.2", 0.75);
}

TEST(shadow, a_penumbra_of_one_width_has_less_noise_than_a_disc_of_just_that_size)
{
    {
        rig::FrameRig rig(truth::plate_over_floor(1.5f));
        rig.request.size = {480, 270};
        rig.look({-1.5f, 2, 0.5f}, {0.3f, 0, 0}, 60);
        expect_softer_than_one_size(rig, "spot,position=0:4:0,outer=40,size=0.2", 0.6, 1024);
        expect_softer_than_one_size(rig, "rect,position=0:4:0,direction=0:-1:0,width=0.4,height=0.4", 0.6, 1024);
        expect_softer_than_one_size(rig, "sun,angle=4", 0.6, 1024);
    }
    // A penumbra of 7 cm is narrower than what the blur may average, seen from either place.
    rig::FrameRig rig(truth::plate_over_floor(0.6f));
    rig.request.size = {320, 180};
    for (const vec3& eye : {vec3(-1.5f, 2, 0.5f), vec3(-2.5f, 0.5f, 0.5f)}) {
        rig.look(eye, {0.3f, 0, 0}, 60);
        expect_softer_than_one_size(rig, "spot,position=0:4:0,outer=40,size=0.2", 0.6, 1024);
        expect_softer_than_one_size(rig, "rect,position=0:4:0,direction=0:-1:0,width=0.4,height=0.4", 0.6, 1024);
    }
}

TEST(shadow, the_blur_leaves_what_lies_behind_an_edge)
{
    rig::FrameRig rig(truth::box_on_floor(0.5f));
    rig.request.size = {640, 360};
    rig.look({2.5f, 2.2f, 1.1f}, {0, 0.5f, 0}, 40);
    rig.light("spot,position=2:6:0,direction=-2:-6:0,outer=40,size=0.8");
    set_filter(rig, "pcss");
    const std::vector<ImageF> got = rig.aovs({"position", "visibility.0"});
    int top = 0, dark = 0;
    for (int y = 0; y < 360; ++y) {
        for (int x = 0; x < 640; ++x) {
            const float height = got[0].at(x, y)[1], seen = *got[1].at(x, y);
            top += height > 0.9999f ? 1 : 0;
            dark += height < 1e-3f && seen < 0.5f ? 1 : 0;
            if (height > 0.9999f) {
                ASSERT_EQ(seen, 1) << x << "," << y; // however dark the floor beyond is
            }
        }
    }
    EXPECT_GT(top, 10000);
    EXPECT_GT(dark, 1000);
}

TEST(shadow, the_reference_converges_to_rays)
{
    rig::FrameRig rig(truth::plate_over_floor(1.5f));
    rig.look({-2.5f, 1.0f, 0.5f}, {0.3f, 0, 0}, 60);
    for (const char* light : {"spot,position=0.4:4:0.8,direction=-0.2:-1:-0.4,outer=40,size=0.3",
                              "rect,position=0.4:4:0.8,direction=0:-1:0,width=1,height=0.5", "sun,angle=6"}) {
        rig.request.lights.clear();
        rig.light(light);
        set_filter(rig, "reference", 512);
        EXPECT_LE(AgainstRays(rig, 1024).error().rmse, 0.02) << light;
    }
}

TEST(shadow, maps_of_what_stays_are_kept_and_change_nothing)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    rig.light("sun,direction=-0.3:-1:-0.2");
    rig.light("spot,position=0:4:0,intensity=200,inner=20,outer=35");
    rig.light("point,position=1:2:1,intensity=50");
    rig.light("rect,position=0:5:0,width=2");
    rig.request.want_picture = true;
    std::vector<std::vector<std::uint8_t>> pictures[2];
    for (const bool cache : {false, true}) {
        rig.set("shadow.cache", cache ? "on" : "off");
        rig.request.lights[1].position = {0, 4, 0};
        rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
        static_cast<void>(rig.render());
        for (int frame = 0; frame < 4; ++frame) {
            if (frame == 1) rig.request.lights[1].position.x += 0.1f;
            if (frame == 2) rig.look({-8.3f, 1.7f, 0.5f}, {8, 2.5f, 0}); // the sun's nearer cascades follow
            const FrameResult drawn = rig.render();
            pictures[cache ? 1 : 0].push_back(drawn.picture.values);
            if (!cache) {
                EXPECT_EQ(map_passes(drawn).size(), 4u);
            } else {
                const std::vector<std::vector<std::string>> known{{}, {"shadow.1"}, {"shadow.0"}, {}};
                EXPECT_EQ(map_passes(drawn), known[static_cast<std::size_t>(frame)]) << frame;
            }
        }
    }
    EXPECT_EQ(pictures[0], pictures[1]);
}

/// Four lights of all kinds, with maps that are small enough to be as large as asked for.
void light_courtyard(rig::FrameRig& rig)
{
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    rig.light("sun,illuminance=3");
    rig.light("spot,position=0:4:0,intensity=200,inner=20,outer=35");
    rig.light("point,position=3:2:1,intensity=50,range=6");
    rig.light("rect,position=0:5:0,width=2");
    rig.set("shadow.resolution", "256");
    rig.request.want_picture = true;
}

TEST(shadow, a_light_removed_from_the_middle_leaves_the_maps_of_the_others)
{
    FrameResult drawn;
    {
        rig::FrameRig rig(rig::courtyard_bake());
        light_courtyard(rig);
        EXPECT_EQ(map_passes(rig.render()).size(), 4u);
        rig.request.lights.erase(rig.request.lights.begin() + 1);
        drawn = rig.render();
        EXPECT_EQ(map_passes(drawn), std::vector<std::string>{});
    }
    rig::FrameRig fresh(rig::courtyard_bake());
    light_courtyard(fresh);
    fresh.request.lights.erase(fresh.request.lights.begin() + 1);
    const FrameResult again = fresh.render();
    EXPECT_EQ(map_passes(again).size(), 3u);
    EXPECT_EQ(drawn.picture.values, again.picture.values);
}

TEST(shadow, a_frame_that_fails_draws_no_map_and_forgets_none)
{
    rig::FrameRig rig(rig::courtyard_bake());
    light_courtyard(rig);
    const auto fail = [&] {
        rig.set("debug.view", "no such image");
        EXPECT_ANY_THROW(static_cast<void>(rig.render()));
        rig.set("debug.view", "");
    };
    fail();
    const FrameResult first = rig.render();
    EXPECT_EQ(map_passes(first).size(), 4u) << "the frame that failed had drawn none";
    fail();
    const FrameResult second = rig.render();
    EXPECT_EQ(map_passes(second), std::vector<std::string>{}) << "and later took none away";
    EXPECT_EQ(first.picture.values, second.picture.values);
}

TEST(shadow, a_moving_light_changes_only_what_it_reaches_and_changes_that_smoothly)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    rig.light("spot,position=0:4:0,intensity=200,inner=20,outer=35");
    rig.light("point,position=3:2:1,intensity=50,range=4,size=0.2");
    rig.request.want_picture = true;
    const ImageF positions = rig.aov("position");
    FrameResult before = rig.render();
    std::uint64_t memory = 0;
    double all = 0;
    for (int step = 1; step <= 300; ++step) {
        rig.request.lights[1].position.z += 0.001f;
        const FrameResult now = rig.render();
        double difference = 0;
        for (int y = 0; y < 180; ++y) {
            for (int x = 0; x < 320; ++x) {
                const float* p = positions.at(x, y);
                const float distance = glm::length(vec3(p[0], p[1], p[2]) - rig.request.lights[1].position);
                for (int c = 0; c < 3; ++c) {
                    const int d = std::abs(now.picture.at(x, y)[c] - before.picture.at(x, y)[c]);
                    difference += d;
                    if (distance > 4.01f) {
                        ASSERT_EQ(d, 0) << x << "," << y << " at step " << step;
                    }
                }
            }
        }
        ASSERT_LT(difference / (320.0 * 180 * 3), 1.0) << step;
        all += difference;
        before = now;
        if (step == 10) memory = rig::engine().device().memory_in_use();
    }
    EXPECT_EQ(rig::engine().device().memory_in_use(), memory);
    EXPECT_GT(all / (320.0 * 180 * 3), 0.5) << "0.3 m further the light ought to change the picture";
}

TEST(shadow, only_so_many_lights_cast_and_those_switched_off_do_not)
{
    rig::FrameRig rig(truth::plate_over_floor(1.5f));
    rig.look({-2.5f, 1.0f, 0.5f}, {0.3f, 0, 0}, 60);
    rig.light("spot,position=0:4:0,shadow=off");
    rig.light("spot,position=0:4:0");
    rig.light("spot,position=0:4:0");
    rig.set("shadow.max_lights", "1");
    const std::vector<ImageF> got = rig.aovs({"visibility.0", "visibility.1", "visibility.2"});
    const auto least = [](const ImageF& image) { return *std::min_element(image.values.begin(), image.values.end()); };
    EXPECT_EQ(least(got[0]), 1);
    EXPECT_EQ(least(got[1]), 0);
    EXPECT_EQ(least(got[2]), 1);
}

TEST(shadow, without_an_extent_pcss_is_nearly_hard)
{
    rig::FrameRig rig(truth::plate_over_floor(1.5f));
    rig.look({-2.5f, 1.0f, 0.5f}, {0.3f, 0, 0}, 60);
    rig.light("spot,position=0.4:4:0.8,direction=-0.2:-1:-0.4,outer=40,size=0.3");
    rig.light("sun,angle=0");
    rig.set("shadow.softness", "0");
    set_filter(rig, "hard");
    const std::vector<ImageF> hard = rig.aovs({"visibility.0", "visibility.1"});
    set_filter(rig, "pcss");
    const std::vector<ImageF> soft = rig.aovs({"visibility.0", "visibility.1"});
    for (std::size_t light = 0; light < 2; ++light) {
        const auto dark =
            std::count_if(hard[light].values.begin(), hard[light].values.end(), [](float v) { return v < 0.5f; });
        EXPECT_GT(dark, 1000) << "there was no shadow to compare, light " << light;
        double difference = 0;
        for (std::size_t i = 0; i < hard[light].values.size(); ++i)
            difference += static_cast<double>(std::abs(hard[light].values[i] - soft[light].values[i]));
        EXPECT_LT(difference / static_cast<double>(hard[light].values.size()), 0.005) << light;
    }
}

TEST(shadow, maps_tell_distances_and_shrink_to_the_budget)
{
    rig::FrameRig rig(truth::floor_scene());
    rig.look({0, 2, 3}, {0, 0, 0});
    rig.light("spot,position=0:4:0");
    rig.light("point,position=0:2:0");
    set_filter(rig, "hard", 1024);
    std::vector<ImageF> got = rig.aovs({"shadow_map.0", "shadow_map.1"});
    EXPECT_EQ(got[0].width, 1024);
    EXPECT_EQ(got[1].width, 6 * 1024);
    EXPECT_NEAR(*got[0].at(512, 512), 4, 1e-4f);
    EXPECT_NEAR(*got[1].at(3 * 1024 + 512, 512), 2, 1e-4f);   // down
    EXPECT_TRUE(std::isinf(*got[1].at(2 * 1024 + 512, 512))); // up
    rig.set("shadow.budget", "10");
    got = rig.aovs({"shadow_map.0", "shadow_map.1"});
    EXPECT_EQ(got[0].width, 512);
    EXPECT_EQ(got[1].width, 6 * 512);
}

} // namespace
} // namespace atrium
