// Culling leaves the picture as it is, and leaves work out.

#include "renderer/core/error.hpp"
#include "renderer/graph/runner.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

namespace atrium {
namespace {

constexpr std::array kinds{"culling.frustum", "culling.cone", "culling.occlusion", "culling.triangles"};

void set_culling(rig::FrameRig& rig, bool on)
{
    for (const char* kind : kinds) rig.set(kind, on ? "on" : "off");
}

/// A frame with AOVs and with what it drew.
FrameResult draw(const rig::FrameRig& rig, const std::vector<std::string>& aovs)
{
    FrameRequest request = rig.request;
    for (const std::string& name : aovs) request.aovs.push_back(parse_aov(name, request.lights));
    request.want_statistics = true;
    return rig::engine().render(request);
}

bool has_pass(const FrameResult& frame, const std::string& name)
{
    const std::vector<graph::PassStats>& passes = frame.stats.passes;
    return std::any_of(passes.begin(), passes.end(), [&](const graph::PassStats& p) { return p.name == name; });
}

std::size_t count_surface(const ImageF& index)
{
    return static_cast<std::size_t>(
        std::count_if(index.values.begin(), index.values.end(), [](float i) { return i >= 0; }));
}

/// Points of a scene's bounds, the same each time.
class RandomPoints {
public:
    RandomPoints(const rig::FrameRig& rig, unsigned seed) : bounds_(rig.bake().scene().bounds), random_(seed) {}
    float unit() { return unit_(random_); }
    vec3 next()
    {
        const float x = unit(), y = unit(), z = unit();
        return bounds_.min + bounds_.extent() * vec3(x, y, z);
    }
    vec3 step() { return next() - bounds_.centre(); } ///< as far as half the scene

private:
    Bounds bounds_;
    std::mt19937 random_;
    std::uniform_real_distribution<float> unit_{0, 1};
};

/// Cameras that jump, each followed by one that stepped aside: what was seen before is wrong at once, then nearly
/// right.
void expect_no_pixel_changed(rig::FrameRig& rig, int cameras)
{
    RandomPoints points(rig, 11);
    vec3 eye(0), target(0);
    float fov = 60;
    std::uint64_t drawn = 0, all = 0;
    std::size_t surface = 0;
    for (int i = 0; i < cameras; ++i) {
        if (i % 2 == 0) {
            eye = points.next();
            target = points.next();
            fov = 20 + 100 * points.unit();
        } else {
            eye += 0.01f * points.step();
        }
        rig.look(eye, target, fov);
        set_culling(rig, true);
        const FrameResult culled = draw(rig, {"depth", "mesh", "albedo"});
        set_culling(rig, false);
        const FrameResult whole = draw(rig, {"depth", "mesh", "albedo"});
        ASSERT_EQ(culled.aovs.size(), 3u);
        for (std::size_t k = 0; k < culled.aovs.size(); ++k)
            ASSERT_EQ(culled.aovs[k].values, whole.aovs[k].values) << "camera " << i << ", AOV " << k;
        drawn += culled.triangles;
        all += whole.triangles;
        surface += count_surface(whole.aovs[1]);
    }
    EXPECT_EQ(all, static_cast<std::uint64_t>(cameras) * (rig.bake().scene().index_count / 3));
    EXPECT_LT(drawn, all / 4) << "there was little to compare: culling left nearly nothing out";
    const std::size_t pixels = std::size_t{rig.request.size.x} * rig.request.size.y * static_cast<unsigned>(cameras);
    EXPECT_GT(surface, pixels / 2) << "there was little to compare: most pixels show nothing";
}

TEST(culling, changes_no_pixel_over_random_cameras_and_cuts)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.size = {97, 55}; // cells of the depth pyramid that the picture fills in part
    expect_no_pixel_changed(rig, 200);
}

TEST(culling, changes_no_pixel_of_sponza)
{
    const auto bake = rig::sponza_bake();
    if (!bake) GTEST_SKIP() << "ATRIUM_SCENES names no folder of real scenes";
    rig::FrameRig rig(*bake);
    rig.request.size = {97, 55};
    expect_no_pixel_changed(rig, 60);
}

TEST(culling, each_kind_leaves_out_more)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.want_statistics = true;
    rig.look({-8, 1.7f, -5}, {8, 2.5f, 2}, 40); // out of an aisle, between columns
    set_culling(rig, false);
    std::uint64_t drawn = rig.render().triangles;
    EXPECT_EQ(drawn, rig.bake().scene().index_count / 3);
    for (const char* kind : kinds) {
        rig.set(kind, "on");
        const std::uint64_t fewer = rig.render().triangles;
        EXPECT_LT(fewer, drawn) << kind;
        drawn = fewer;
    }
}

TEST(culling, a_wall_hides_what_stands_behind_it)
{
    truth::SceneBuilder builder;
    const std::uint32_t grey = builder.add_material("grey");
    builder.add_mesh("wall", grey, truth::quad({-4, -3, 0}, {8, 0, 0}, {0, 6, 0}));
    for (int i = 0; i < 5; ++i)
        builder.add_mesh("ball" + std::to_string(i), grey, truth::sphere({i - 2, 0, -3}, 0.5f, 32));
    rig::FrameRig rig(builder.finish());
    rig.request.want_statistics = true;
    rig.look({0, 0, 4}, {0, 0, 0});
    for (const char* triangles : {"off", "on"}) {
        rig.set("culling.triangles", triangles);
        rig.set("culling.occlusion", "off");
        EXPECT_GT(rig.render().triangles, 500u);
        rig.set("culling.occlusion", "on");
        EXPECT_EQ(rig.render().triangles, 2u); // the wall's
    }
    rig.look({0, 4, -3}, {0, 0, -3.1f}); // a cut to behind the wall
    EXPECT_GT(rig.render().triangles, 500u);
}

/// Walks with cuts, each frame with what the one before saw; at times with other kinds of culling in between.
void expect_memory_hides_nothing(rig::FrameRig& rig, int frames)
{
    RandomPoints points(rig, 5);
    vec3 eye(0), target(0);
    std::size_t pixels = 0, others = 0;
    int remembering = 0, expected = 0;
    for (int i = 0; i < frames; ++i) {
        if (i % 8 == 0) {
            eye = points.next();
            target = points.next();
        } else {
            eye += 0.01f * points.step();
        }
        rig.look(eye, target, 70);
        rig.set("culling.occlusion", i % 16 == 5 ? "off" : "on");
        rig.set("culling.triangles", i % 16 == 12 ? "off" : "on");
        rig.request.remember = false;
        const std::vector<ImageF> fresh = rig.aovs({"depth", "mesh"});
        rig.request.remember = true;
        const FrameResult frame = draw(rig, {"depth", "mesh"});
        const std::vector<ImageF>& remembered = frame.aovs;
        remembering += has_pass(frame, "gbuffer.late") ? 1 : 0;
        expected += i % 16 == 5 || i % 16 == 12 ? 0 : 1;
        ASSERT_EQ(remembered[0].values, fresh[0].values) << "frame " << i;
        for (std::size_t p = 0; p < fresh[1].values.size(); ++p) {
            ++pixels;
            others += fresh[1].values[p] != remembered[1].values[p] ? 1 : 0;
        }
    }
    EXPECT_LE(others, pixels / 1000); // surfaces at the same depth
    EXPECT_GT(pixels, 0u);
    EXPECT_EQ(remembering, expected);
}

TEST(culling, memory_hides_nothing)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.size = {97, 55};
    expect_memory_hides_nothing(rig, 160);
}

TEST(culling, memory_hides_nothing_of_sponza)
{
    const auto bake = rig::sponza_bake();
    if (!bake) GTEST_SKIP() << "ATRIUM_SCENES names no folder of real scenes";
    rig::FrameRig rig(*bake);
    rig.request.size = {97, 55};
    expect_memory_hides_nothing(rig, 64);
}

TEST(culling, a_still_camera_remembers_the_same_picture_and_draws_less)
{
    rig::FrameRig rig(rig::courtyard_bake());
    set_culling(rig, true);
    rig.request.want_picture = rig.request.want_statistics = true;
    rig.look({-8, 1.7f, -5}, {8, 2.5f, 2}, 40);
    const FrameResult fresh = rig.render();
    rig.request.remember = true;
    for (int frame = 0; frame < 8; ++frame) EXPECT_EQ(rig.render().picture.values, fresh.picture.values);
    EXPECT_LT(rig.render().triangles, 0.9 * static_cast<double>(fresh.triangles));
    rig.set("culling.triangles", "off"); // forgets nothing that it must know
    EXPECT_EQ(rig.render().picture.values, fresh.picture.values);
    rig.set("culling.triangles", "on");
    EXPECT_EQ(rig.render().picture.values, fresh.picture.values);
}

TEST(culling, a_frame_that_fails_is_not_remembered)
{
    rig::FrameRig rig(rig::courtyard_bake());
    set_culling(rig, true);
    rig.look({-8, 1.7f, -5}, {8, 2.5f, 2}, 40);
    const ImageF fresh = rig.aov("depth");
    rig.request.remember = true;
    rig.set("debug.view", "dpeth");
    EXPECT_THROW(static_cast<void>(rig.render()), Error);
    rig.set("debug.view", "");
    EXPECT_EQ(rig.aov("depth").values, fresh.values);
    EXPECT_EQ(rig.aov("depth").values, fresh.values);
}

/// A field of 350 x 200 squares, seen whole from above: a third lies face up, a third face down, and the rest are
/// specks of which hardly one covers a pixel's centre. More clusters than a row of a dispatch has groups (65,535).
class Field {
public:
    static constexpr int across = 350, along = 200, count = across * along;
    static constexpr int face_up = (count + 2) / 3, face_down = (count + 1) / 3;

    Field() : rig_(field_square())
    {
        SceneDescription scene;
        scene.bakes.push_back(&rig_.bake());
        for (int i = 0; i < count; ++i) {
            const vec3 at = place(i);
            mat4 m = glm::translate(mat4(1), at);
            if (i % 3 == 1) m = glm::rotate(m, pi, vec3(1, 0, 0));
            if (i % 3 == 2) m = glm::scale(m, vec3(0.005f));
            scene.instances.push_back({0, std::nullopt, m});
        }
        rig::engine().load(scene);
        rig_.look(eye, {0, 0, 0});
        rig_.request.size = {1280, 720}; // so that each triangle of those that face up covers a pixel's centre
    }
    [[nodiscard]] rig::FrameRig& rig() { return rig_; }

    /// Pixels that show the `n` squares farthest from the eye, which are the last ones in draw order.
    [[nodiscard]] static std::size_t pixels_of_farthest(const ImageF& instances, std::size_t n)
    {
        std::vector<float> distances;
        for (int i = 0; i < count; ++i) distances.push_back(glm::length(place(i) - eye));
        std::vector<float> sorted = distances;
        std::sort(sorted.begin(), sorted.end());
        const float least = sorted[sorted.size() - n];
        return static_cast<std::size_t>(std::count_if(instances.values.begin(), instances.values.end(), [&](float i) {
            return i >= 0 && distances[static_cast<std::size_t>(i)] > least;
        }));
    }

private:
    static constexpr float step = 0.28f; ///< m; a pixel is 0.08 m wide
    inline static const vec3 eye{0, 50, 0.01f};
    static BakeData field_square()
    {
        truth::SceneBuilder builder;
        builder.add_mesh("square", builder.add_material("grey"), truth::ground(0.125f));
        return builder.finish();
    }
    static vec3 place(int i)
    {
        return step * vec3(static_cast<float>(i % across - across / 2), 0, static_cast<float>(i / across - along / 2));
    }
    rig::FrameRig rig_;
};

TEST(culling, more_clusters_than_a_row_of_a_dispatch_has_groups)
{
    Field field;
    rig::FrameRig& rig = field.rig();
    ASSERT_GT(rig::engine().scene().tasks().count, 65'535u);
    EXPECT_EQ(rig::engine().scene().note(), "");
    const std::vector<std::string> names{"depth", "instance"};
    set_culling(rig, false);
    const FrameResult whole = draw(rig, names);
    EXPECT_EQ(whole.triangles, 2u * Field::count);
    // Squares beyond the first row of groups are seen: 4,465 are, less those that share the distance of the last.
    EXPECT_GT(Field::pixels_of_farthest(whole.aovs[1], 4400), 5000u);
    set_culling(rig, true);
    for (const bool remember : {false, true, true}) {
        rig.request.remember = remember;
        const FrameResult culled = draw(rig, names);
        EXPECT_EQ(has_pass(culled, "gbuffer.late"), remember);
        for (std::size_t k = 0; k < names.size(); ++k)
            EXPECT_EQ(culled.aovs[k].values, whole.aovs[k].values) << names[k] << ", remember " << remember;
        // Nothing of the back sides and specks; 1,488 of either are beyond the first row of groups.
        EXPECT_GE(culled.triangles, 2u * Field::face_up) << "remember " << remember;
        EXPECT_LT(culled.triangles, 2u * Field::face_up + 100) << "remember " << remember;
    }
    rig.request.remember = false;
    for (const char* kind : {"culling.frustum", "culling.occlusion", "culling.triangles"}) rig.set(kind, "off");
    EXPECT_EQ(draw(rig, {}).triangles, 2u * (Field::count - Field::face_down)); // the cone alone: no back sides
    set_culling(rig, true);
    rig.look({0, 50, 0}, {0, 100, 0.01f}); // away from it
    EXPECT_EQ(draw(rig, {}).triangles, 0u);
}

TEST(culling, says_why_it_cannot_cull_triangles)
{
    gpu::DeviceReport device;
    device.optional.subgroup_ballot = true;
    device.storage_range = 128 << 20;
    EXPECT_EQ(triangle_culling_refusal(device, {128 << 20, 1, 1}), "");
    for (const auto& [bytes, what] :
         {std::pair{TriangleBytes{129 << 20, 0, 0}, "the scene's vertices take 129 MiB"},
          std::pair{TriangleBytes{0, 256 << 20, 0}, "the scene's indices take 256 MiB"},
          std::pair{TriangleBytes{0, 0, std::uint64_t{6000} << 20}, "indices of all instances take 6000 MiB"}}) {
        const std::string text = triangle_culling_refusal(device, bytes);
        EXPECT_NE(text.find(what), std::string::npos) << text;
        EXPECT_NE(text.find("128 MiB of a buffer"), std::string::npos) << text;
        EXPECT_NE(text.find("culling.triangles"), std::string::npos) << text;
    }
    device.optional.subgroup_ballot = false;
    EXPECT_NE(triangle_culling_refusal(device, {}).find("ballots"), std::string::npos);
}

TEST(draws, bind_once_per_class_and_draw_at_most_once_per_material)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.want_picture = true; // else nobody reads what gbuffer draws
    int drawing = 0;
    for (const graph::PassStats& pass : rig.render().stats.passes) {
        if (pass.name != "gbuffer") continue;
        ++drawing;
        EXPECT_GE(pass.pipeline_binds, 1u);
        EXPECT_LE(pass.pipeline_binds, 4u);
        EXPECT_GE(pass.draws, 2u); // one-sided and two-sided ones at least
        EXPECT_LE(pass.draws, rig.bake().scene().materials.size());
    }
    EXPECT_EQ(drawing, 1) << "no pass is called gbuffer, or several are";
}

TEST(draws, the_same_frame_twice_gives_the_same_bytes)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.want_picture = rig.request.want_hdr = true;
    rig.light("sun");
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    const FrameResult first = rig.render(), second = rig.render();
    EXPECT_EQ(first.picture.values, second.picture.values);
    EXPECT_EQ(first.hdr.values, second.hdr.values);
}

} // namespace
} // namespace atrium
