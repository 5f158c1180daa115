// AOVs against the ray caster, and their backgrounds.

#include "renderer/core/error.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/compare.hpp"
#include "tests/truth/primary.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shapes.hpp"
#include "tests/truth/truth_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace atrium {
namespace {

struct View {
    const char* name;
    vec3 eye, target;
    float fov;
};

/// The bounds that the renderer promises: shares of the pixels off silhouettes.
constexpr double depth_tolerance = 0.002, depth_share = 0.995;
constexpr double normal_degrees = 1.0, normal_share = 0.99;
constexpr double material_share = 0.995, masked_share = 0.97;

void expect_share(const std::string& name, const truth::Agreement& a, double share)
{
    EXPECT_GE(a.share_within, share) << name << ": " << a.text()
                                     << (a.share_within < share ? truth::write_failure(name, a) : "");
}

/// Depth, geometric normal and material of one view, opaque and masked pixels apart. Returns the share of masked
/// pixels.
double expect_truth(rig::FrameRig& rig, const truth::TruthScene& scene, const View& view)
{
    rig.look(view.eye, view.target, view.fov);
    rig.set("debug.alpha_lod0", "on");
    const std::vector<ImageF> got = rig.aovs({"depth", "geometric_normal", "material"});
    const ivec2 size(rig.request.size);
    const truth::PrimaryBuffers want =
        truth::cast_primary(scene, rig.request.camera, size, default_near(rig.bake().scene().bounds));
    const truth::Mask steady = truth::inverse(truth::silhouettes(want));
    const truth::Mask opaque = truth::without(steady, want.alpha), masked = truth::both(steady, want.alpha);
    const std::string name = view.name;
    expect_share(name + "-depth", truth::compare_depth(want.depth, got[0], opaque, depth_tolerance), depth_share);
    expect_share(name + "-normal", truth::compare_directions(want.geometric_normal, got[1], opaque, normal_degrees),
                 normal_share);
    expect_share(name + "-material", truth::compare_indices(want.material, got[2], opaque), material_share);
    if (masked.share() < 0.002) return 0; // too few pixels to speak of shares
    expect_share(name + "-masked-depth", truth::compare_depth(want.depth, got[0], masked, depth_tolerance),
                 masked_share);
    expect_share(name + "-masked-material", truth::compare_indices(want.material, got[2], masked), masked_share);
    return masked.share();
}

TEST(aov, courtyard_agrees_with_the_ray_caster)
{
    rig::FrameRig rig(rig::courtyard_bake());
    const truth::TruthScene scene(rig.bake());
    rig.request.size = {480, 270};
    double masked = 0;
    for (const View& view :
         {View{"court-length", {-8, 1.7f, 0.5f}, {8, 2.5f, 0}, 60}, View{"court-down", {3, 7, -2}, {-4, 1, 2}, 65},
          View{"court-aisle", {6, 1.8f, -5.5f}, {-6, 2, -4.5f}, 55}, View{"court-up", {0, 1.2f, 3}, {-3, 6, -6}, 75}}) {
        masked += expect_truth(rig, scene, view);
    }
    EXPECT_GT(masked, 0.01) << "no view shows masked materials";
}

TEST(aov, sponza_agrees_with_the_ray_caster)
{
    const auto bake = rig::sponza_bake();
    if (!bake) GTEST_SKIP() << "ATRIUM_SCENES names no folder of real scenes";
    rig::FrameRig rig(*bake);
    const truth::TruthScene scene(rig.bake());
    rig.request.size = {640, 360};
    double masked = 0;
    for (const View& view :
         {View{"nave", {-11.5f, 1.7f, -0.4f}, {10, 3.5f, -0.4f}, 60},
          View{"gallery", {-12.5f, 6, 4.6f}, {8, 5.5f, -2}, 60}, View{"aisle", {9.5f, 1.8f, -4.8f}, {-6, 2.2f, -3}, 55},
          View{"above", {3, 9, -0.4f}, {-12, 4, -0.4f}, 65},
          View{"plant", {-2.4f, 0.9f, -0.9f}, {-2.4f, 0.35f, -2.2f}, 45},
          View{"lion", {10.3f, 1.9f, -0.3f}, {13, 1.7f, -0.37f}, 55},
          View{"chain", {4.9f, 2, -0.4f}, {5, 1.5f, -2.2f}, 50}}) {
        masked += expect_truth(rig, scene, view);
    }
    EXPECT_GT(masked, 0.01) << "no view shows masked materials";
}

TEST(aov, masked_quad_shows_its_mask_texel_by_texel)
{
    const std::vector<std::uint8_t> alpha{255, 0, 255, 255, 0, 255, 0, 255, 255, 255, 0, 0, 0, 255, 255, 255};
    rig::FrameRig rig(truth::masked_scene(4, 4, alpha));
    const truth::TruthScene scene(rig.bake());
    EXPECT_GT(expect_truth(rig, scene, {"mask", {0.2f, 0.1f, 3}, {0, 0, 0}, 45}), 0.1);
}

TEST(aov, known_values_of_a_plane)
{
    rig::FrameRig rig(truth::floor_scene());
    rig.look({0, 2, 0}, {0, 0, -2}, 60); // 45 degrees down
    const std::vector<ImageF> got =
        rig.aovs({"depth", "position", "geometric_normal", "normal", "material", "mesh", "instance"});
    // Pixel (159, 89) looks half a pixel up and left of the axis: at distance t along the view axis the floor is met
    // where 2 = t (sin 45 + cos 45 tan(angle down)).
    const float tan_y = std::tan(glm::radians(30.0f)) / 90 * -0.5f;
    const float depth = 2 / (std::sqrt(0.5f) * (1 + tan_y));
    EXPECT_NEAR(*got[0].at(159, 89), depth, 1e-4f * depth);
    EXPECT_NEAR(got[1].at(159, 89)[1], 0, 1e-3f);
    for (const int i : {2, 3}) EXPECT_NEAR(got[static_cast<std::size_t>(i)].at(159, 89)[1], 1, 1e-3f);
    for (const int i : {4, 5, 6}) EXPECT_EQ(*got[static_cast<std::size_t>(i)].at(159, 89), 0);
}

TEST(aov, background_is_what_the_table_says)
{
    rig::FrameRig rig(truth::floor_scene());
    rig.look({0, 2, 0}, {0, 5, -1});
    rig.light("sun,name=key");
    rig.set("shadow.filter", "off");
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<std::pair<std::string, float>> known{
        {"depth", inf},     {"position", 0},   {"geometric_normal", 0}, {"normal", 0},         {"albedo", 0},
        {"roughness", 0},   {"metallic", 0},   {"specular", 0},         {"emission", 0},       {"material", -1},
        {"mesh", -1},       {"instance", -1},  {"motion", 0},           {"light.key", 0},      {"ambient", 0},
        {"ao", 1},          {"ao_raw", 1},     {"visibility.0", 1},     {"shadow_map.0", inf}, {"cascade.0", -1},
        {"blocker.0", inf}, {"penumbra.0", 0}, {"overdraw", 0},         {"light_count", 0},    {"depth_complexity", 0}};
    std::vector<std::string> names;
    for (const auto& [name, value] : known) names.push_back(name);
    const std::vector<ImageF> got = rig.aovs(names);
    for (std::size_t i = 0; i < known.size(); ++i) EXPECT_EQ(*got[i].at(160, 90), known[i].second) << known[i].first;
}

/// Walls that face the camera at z = 0, 1 and 2, each drawn after those before it. The left halves stand behind each
/// other, the last one is whole.
BakeData walls()
{
    truth::SceneBuilder builder;
    const std::uint32_t grey = builder.add_material("grey");
    for (const float z : {0.0f, 1.0f}) builder.add_mesh("half", grey, truth::quad({-2, -2, z}, {2, 0, 0}, {0, 4, 0}));
    builder.add_mesh("whole", grey, truth::quad({-2, -2, 2}, {4, 0, 0}, {0, 4, 0}));
    return builder.finish();
}

TEST(aov, fragments_are_counted_before_and_after_the_depth_test)
{
    rig::FrameRig rig(walls());
    for (const char* kind : {"culling.frustum", "culling.cone", "culling.occlusion", "culling.triangles"})
        rig.set(kind, "off");
    const ivec2 left(140, 90), right(180, 90);
    const std::vector<std::string> names{"depth_complexity", "overdraw"};
    rig.look({0, 0, 8}, {0, 0, 0});
    const std::vector<ImageF> front = rig.aovs(names);
    EXPECT_EQ(*front[0].at(left.x, left.y), 3);
    EXPECT_EQ(*front[0].at(right.x, right.y), 1);
    EXPECT_EQ(*front[1].at(left.x, left.y), 1); // what is nearest is drawn first
    EXPECT_EQ(*front[1].at(right.x, right.y), 1);
    rig.look({0, 0, -8}, {0, 0, 0}); // from behind, where nothing is drawn
    for (const ImageF& count : rig.aovs(names)) EXPECT_EQ(*count.at(left.x, left.y), 0);
}

TEST(aov, lights_are_counted_by_range_cone_and_front)
{
    rig::FrameRig rig(truth::floor_scene());
    rig.look({0, 10, 0.01f}, {0, 0, 0}, 90); // 10 m to each side along the height of the picture
    rig.light("point,position=-5:1:0,range=3");
    rig.light("spot,position=5:2:0,direction=0:-1:0,inner=20,outer=45"); // a circle of 2 m
    rig.light("rect,position=0:1:0,direction=0:1:0");                    // which turns its back on the floor
    rig.light("sun,direction=0:-1:0");
    const ImageF count = rig.aov("light_count");
    const auto at = [&](float x) { return *count.at(160 + static_cast<int>(x * 9), 90); };
    EXPECT_EQ(at(-10), 1); // the sun alone
    EXPECT_EQ(at(-5), 2);
    EXPECT_EQ(at(-1.5f), 1);
    EXPECT_EQ(at(0), 1);
    EXPECT_EQ(at(2.5f), 1);
    EXPECT_EQ(at(5), 2);
    EXPECT_EQ(at(7.5f), 1);
}

TEST(aov, channels_are_one_for_scalars_two_for_motion_three_for_vectors)
{
    rig::FrameRig rig(truth::floor_scene());
    rig.light("sun");
    const std::vector<ImageF> got = rig.aovs({"depth", "motion", "position", "light.0", "hdr"});
    EXPECT_EQ(got[0].channels, 1);
    EXPECT_EQ(got[1].channels, 2);
    for (const std::size_t i : {2u, 3u, 4u}) EXPECT_EQ(got[i].channels, 3);
}

TEST(aov, unknown_names_and_lights_are_refused_with_the_nearest)
{
    const std::vector<Light> lights = [] {
        std::vector<Light> l{parse_light("sun,name=key")};
        name_lights(l);
        return l;
    }();
    try {
        static_cast<void>(parse_aov("dpeth", lights));
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::usage);
        EXPECT_NE(e.text().find("depth"), std::string::npos);
    }
    EXPECT_THROW(static_cast<void>(parse_aov("light.kye", lights)), Error);
    EXPECT_THROW(static_cast<void>(parse_aov("light", lights)), Error);
    EXPECT_THROW(static_cast<void>(parse_aov("depth.0", lights)), Error);
    EXPECT_EQ(parse_aov("light.key", lights).light, 0u);
}

} // namespace
} // namespace atrium
