// Motion of every pixel against the closed form: its surface point's position now and in the previous frame.

#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>

namespace atrium {
namespace {

/// A box without a floor; the AOV `instance` identifies its instances.
BakeData lone_box()
{
    truth::SceneBuilder builder;
    builder.add_mesh("box", builder.add_material("grey"), truth::box(vec3(-0.5f), vec3(0.5f)));
    return builder.finish();
}

/// Screen UV of a point; in double, because differences of it are compared.
std::optional<glm::dvec2> project(const Camera& camera, double aspect, const glm::dvec3& p)
{
    const glm::dvec4 view = glm::dmat4(view_from_world(camera)) * glm::dvec4(p, 1);
    if (view.z >= 0) return std::nullopt;
    const double f = 1 / std::tan(glm::radians(static_cast<double>(camera.fov)) / 2);
    return glm::dvec2(0.5 + 0.5 * f / aspect * view.x / -view.z, 0.5 - 0.5 * f * view.y / -view.z);
}

struct MotionError {
    double worst = 0; ///< UV
    double moved = 0; ///< mean length of the motion that is expected, UV
    int pixels = 0;
};

/// By instance. `now` and `before`: of those that moved.
std::map<int, MotionError> motion_errors(const rig::FrameRig& rig, const std::map<int, std::pair<mat4, mat4>>& moved)
{
    const std::vector<ImageF> got = rig.aovs({"motion", "position", "instance"});
    const double aspect = static_cast<double>(rig.request.size.x) / rig.request.size.y;
    std::map<int, MotionError> errors;
    for (int y = 0; y < got[0].height; ++y) {
        for (int x = 0; x < got[0].width; ++x) {
            const int instance = static_cast<int>(*got[2].at(x, y));
            const float *m = got[0].at(x, y), *p = got[1].at(x, y);
            if (instance < 0) {
                EXPECT_TRUE(m[0] == 0 && m[1] == 0) << "background at " << x << "," << y;
                continue;
            }
            glm::dvec3 was(p[0], p[1], p[2]);
            if (const auto found = moved.find(instance); found != moved.end()) {
                const auto& [now, before] = found->second;
                was = glm::dmat4(before) * (glm::inverse(glm::dmat4(now)) * glm::dvec4(was, 1));
            }
            const auto before = project(rig.request.previous_camera, aspect, was);
            const glm::dvec2 here((x + 0.5) / got[0].width, (y + 0.5) / got[0].height);
            const glm::dvec2 expected = before ? here - *before : glm::dvec2(0);
            MotionError& e = errors[instance];
            e.worst = std::max(e.worst, glm::length(glm::dvec2(m[0], m[1]) - expected));
            e.moved += glm::length(expected);
            ++e.pixels;
        }
    }
    for (auto& [instance, e] : errors) e.moved /= e.pixels;
    return errors;
}

/// A half float holds motions below 1/8 to 2^-14 of the picture; two components and the position's own rounding.
constexpr double tolerance = 1.5 / 16384;

void expect_motion(const MotionError& e, double least_motion, const std::string& what)
{
    EXPECT_GT(e.pixels, 500) << what;
    EXPECT_GT(e.moved, least_motion) << what;
    EXPECT_LE(e.worst, tolerance) << what;
}

TEST(motion, is_zero_for_what_stands_still)
{
    rig::FrameRig rig(truth::box_on_floor());
    rig.look({1, 2, 3}, {0, 0, 0});
    const std::vector<ImageF> got = rig.aovs({"motion", "instance"});
    int pixels = 0;
    for (const float i : got[1].values) pixels += i >= 0 ? 1 : 0;
    EXPECT_GT(pixels, 10000);
    for (const float v : got[0].values) EXPECT_LT(std::abs(v), 1e-6f);
}

TEST(motion, of_a_camera_has_the_closed_form)
{
    rig::FrameRig rig(truth::box_on_floor());
    const Camera now{{1, 2, 3}, {0, 0.2f, 0}, 60};
    const std::pair<const char*, Camera> befores[]{{"aside", {{0.9f, 2, 3}, {-0.1f, 0.2f, 0}, 60}},
                                                   {"up", {{1, 2.1f, 3}, {0, 0.3f, 0}, 60}},
                                                   {"nearer", {{0.95f, 1.91f, 2.85f}, {0, 0.2f, 0}, 60}},
                                                   {"yaw", {{1, 2, 3}, {0.05f, 0.2f, -0.02f}, 60}},
                                                   {"pitch", {{1, 2, 3}, {0, 0.3f, 0}, 60}},
                                                   {"zoom", {{1, 2, 3}, {0, 0.2f, 0}, 55}},
                                                   {"all", {{1.1f, 1.9f, 3.1f}, {0.05f, 0.25f, 0}, 63}}};
    for (const auto& [name, before] : befores) {
        rig.request.camera = now;
        rig.request.previous_camera = before;
        const std::map<int, MotionError> errors = motion_errors(rig, {});
        ASSERT_EQ(errors.size(), 1u) << name;
        expect_motion(errors.at(0), 0.002, name);
    }
}

TEST(motion, of_a_yawing_camera_is_the_tangent)
{
    // The camera turns left by delta: what was central moves right by tan(delta) f / (2 aspect) of the width.
    rig::FrameRig rig(truth::floor_scene());
    const float delta = glm::radians(1.0f);
    const vec3 eye(0, 0.5f, 0), ahead(0, -0.05f, -1), left(-std::sin(delta), -0.05f, -std::cos(delta));
    rig.look(eye, eye + left);
    rig.request.previous_camera = {eye, eye + ahead, 60};
    const float f = 1 / std::tan(glm::radians(30.0f)), aspect = 320.0f / 180.0f,
                moved = std::tan(delta) * f / (2 * aspect);
    const ImageF motion = rig.aov("motion");
    // The point that was central is now `moved` to the right of the middle.
    EXPECT_NEAR(*motion.at(160 + static_cast<int>(moved * 320), 90), moved, 3e-4f); // half floats
}

/// Three boxes: one at rest, one that is moved, and one between them and the camera.
struct Boxes : ::testing::Test {
    Boxes() : rig(lone_box())
    {
        rig.look({0, 1, 5}, {0, 0, 0});
        load(glm::translate(mat4(1), vec3(1.2f, 0, 0)));
    }
    void load(const mat4& moved_box)
    {
        now = moved_box;
        SceneDescription scene;
        scene.bakes.push_back(&rig.bake());
        scene.instances.push_back({0, std::nullopt, glm::translate(mat4(1), vec3(-1.2f, 0, 0))});
        scene.instances.push_back({0, std::nullopt, moved_box});
        rig::engine().load(scene);
    }
    mat4 now{1};
    rig::FrameRig rig;
};
using motion_of_boxes = Boxes;

TEST_F(motion_of_boxes, that_move_turn_and_grow_has_the_closed_form)
{
    const mat4 place = glm::translate(mat4(1), vec3(1.2f, 0, 0));
    const std::pair<const char*, mat4> befores[]{
        {"moved", glm::translate(mat4(1), vec3(1.1f, 0.05f, -0.1f))},
        {"turned", glm::rotate(place, glm::radians(5.0f), glm::normalize(vec3(0.3f, 1, 0.2f)))},
        {"grown", glm::scale(place, vec3(0.9f, 0.95f, 1.05f))}};
    for (const auto& [name, before] : befores) {
        for (const bool camera_moves : {false, true}) {
            const std::string what = std::string(name) + (camera_moves ? ", and the camera too" : "");
            rig.request.previous_camera = rig.request.camera;
            if (camera_moves) rig.request.previous_camera.eye += vec3(0.1f, -0.05f, 0.1f);
            rig.request.previous_instances = {{1, before}};
            std::map<int, MotionError> errors = motion_errors(rig, {{1, {now, before}}});
            ASSERT_EQ(errors.size(), 2u) << what;
            expect_motion(errors[1], 0.002, what);
            if (camera_moves) {
                expect_motion(errors[0], 0.002, what + ": the box at rest");
            } else {
                EXPECT_LE(errors[0].worst, 1e-6) << what; // the box at rest has none
                EXPECT_GT(errors[0].pixels, 500) << what;
            }
        }
    }
}

TEST_F(motion_of_boxes, ends_with_the_frame_in_which_they_moved)
{
    rig.request.previous_instances = {{1, glm::translate(mat4(1), vec3(1, 0, 0))}};
    EXPECT_GT(motion_errors(rig, {})[1].worst, 0.01); // against boxes at rest
    rig.request.previous_instances.clear();
    std::map<int, MotionError> errors = motion_errors(rig, {});
    for (const int instance : {0, 1}) {
        EXPECT_GT(errors[instance].pixels, 500) << instance;
        EXPECT_LE(errors[instance].worst, 1e-6) << instance;
    }
}

TEST_F(motion_of_boxes, outlives_a_change_of_their_material_s_class)
{
    const mat4 before = glm::translate(mat4(1), vec3(1.1f, 0, 0));
    rig.request.previous_instances = {{1, before}};
    expect_motion(motion_errors(rig, {{1, {now, before}}})[1], 0.002, "opaque");
    rig.request.materials = {{"grey", {{"class", "masked"}}}}; // its records are classified again
    expect_motion(motion_errors(rig, {{1, {now, before}}})[1], 0.002, "masked");
}

TEST_F(motion_of_boxes, changes_nothing_else)
{
    const std::vector<std::string> names{"depth", "normal", "albedo", "mesh", "instance", "hdr"};
    const std::vector<ImageF> still = rig.aovs(names);
    rig.request.previous_instances = {{1, glm::translate(mat4(1), vec3(1, 0, 0))}};
    const std::vector<ImageF> moved = rig.aovs(names);
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(moved[i].values, still[i].values) << names[i];
}

} // namespace
} // namespace atrium
