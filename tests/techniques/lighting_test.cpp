// Light against closed forms: what leaves a diffuse floor under each type of light.

#include "tests/rig/frame_rig.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace atrium {
namespace {

constexpr float albedo = 0.5f;

/// A floor that reflects no specular light, seen from 4 m above; pixel (160, 90) lies half a pixel from its middle.
rig::FrameRig diffuse_floor()
{
    BakeData scene = truth::floor_scene();
    Material& m = scene.scene.materials.front();
    m.base_color = vec3(albedo);
    m.base_color_texture = m.surface_texture = m.normal_texture = no_texture;
    m.roughness = 1;
    m.metallic = 0;
    m.specular = 0;
    return rig::FrameRig(scene);
}

struct Floor {
    Floor() : rig(diffuse_floor())
    {
        rig.look({0, 4, 0}, {0, 0, 0});
        rig.set("ambient.intensity", "0");
    }
    /// Mean of the four pixels around the middle, red.
    [[nodiscard]] float middle(const std::string& aov) const
    {
        const ImageF image = rig.aov(aov);
        return 0.25f * (*image.at(159, 89) + *image.at(160, 89) + *image.at(159, 90) + *image.at(160, 90));
    }
    rig::FrameRig rig;
};

/// The base colour went through 8-bit sRGB; what the G-buffer holds is what light falls on.
float stored_albedo(const Floor& floor)
{
    return floor.middle("albedo");
}

TEST(lighting, a_sun_gives_albedo_times_illuminance_over_pi)
{
    Floor floor;
    floor.rig.light("sun,direction=0:-1:0,illuminance=10");
    EXPECT_NEAR(floor.middle("light.0"), stored_albedo(floor) * 10 / pi, 1e-3f);
    EXPECT_NEAR(stored_albedo(floor), albedo, 0.004f);
}

TEST(lighting, a_slanting_sun_gives_the_cosine)
{
    Floor floor;
    floor.rig.light("sun,direction=1:-1:0,illuminance=10");
    EXPECT_NEAR(floor.middle("light.0"), stored_albedo(floor) * 10 * std::sqrt(0.5f) / pi, 1e-3f);
}

TEST(lighting, a_point_light_falls_off_with_the_square_of_distance)
{
    for (const float height : {1.0f, 2.0f, 3.0f}) {
        Floor floor;
        floor.rig.light("point,position=0:" + std::to_string(height) + ":0,intensity=100");
        EXPECT_NEAR(floor.middle("light.0"), stored_albedo(floor) * 100 / (pi * height * height),
                    2e-3f * 100 / (height * height))
            << height;
    }
}

TEST(lighting, a_range_ends_the_light_smoothly)
{
    Floor floor;
    floor.rig.light("point,position=0:2:0,intensity=100,range=4");
    const float window = std::pow(1 - std::pow(0.5f, 4.0f), 2.0f);
    EXPECT_NEAR(floor.middle("light.0"), stored_albedo(floor) * 100 / (4 * pi) * window, 0.01f);
    Floor beyond;
    beyond.rig.light("point,position=0:2:0,intensity=100,range=1.9");
    EXPECT_EQ(beyond.middle("light.0"), 0.0f);
}

TEST(lighting, a_spot_fades_between_its_angles)
{
    // Middle of the floor at 25 degrees from the axis of a spot of 20 and 30.
    const float angle = glm::radians(25.0f), inner = std::cos(glm::radians(20.0f)),
                outer = std::cos(glm::radians(30.0f));
    const float t = (std::cos(angle) - outer) / (inner - outer);
    Floor floor;
    floor.rig.light("spot,position=0:2:0,direction=" + std::to_string(std::sin(angle)) + ":" +
                    std::to_string(-std::cos(angle)) + ":0,intensity=100,inner=20,outer=30");
    EXPECT_NEAR(floor.middle("light.0"), stored_albedo(floor) * 100 / (4 * pi) * t * t, 0.02f);
}

TEST(lighting, a_rectangle_gives_its_form_factor)
{
    // Square of 2 h x 2 h centred h above: form factor 0.554126 (four rectangles with a corner above, A = B = 1).
    Floor floor;
    floor.rig.light("rect,position=0:1:0,direction=0:-1:0,width=2,height=2,radiance=10");
    EXPECT_NEAR(floor.middle("light.0"), stored_albedo(floor) * 10 * 0.554126f, 0.005f);
    Floor behind; // one-sided
    behind.rig.light("rect,position=0:1:0,direction=0:1:0,width=2,height=2,radiance=10");
    EXPECT_EQ(behind.middle("light.0"), 0.0f);
}

TEST(lighting, a_rectangle_half_below_the_horizon_is_clipped)
{
    // Vertical 4 x 4 in the plane z = -1, centred in the floor: only its upper half sends light. Upright rectangle
    // whose lower edge lies in the receiver's plane, width 2a on both sides: F = 1/pi (atan(X) - Y atan(X Y)), with the
    // distance 1, half width a = 2, height 2: X = a / 1, Y = 1 / sqrt(1 + h^2).
    const double x = 2, h = 2, y = 1 / std::sqrt(1 + h * h);
    const double form = (std::atan(x) - y * std::atan(x * y)) / pi;
    Floor floor;
    floor.rig.light("rect,position=0:0:-1,direction=0:0:1,width=4,height=4,radiance=10");
    EXPECT_NEAR(floor.middle("light.0"), stored_albedo(floor) * 10 * form, 0.01);
}

TEST(lighting, ambient_is_the_hemisphere_s_colour)
{
    Floor floor;
    floor.rig.set("ambient.intensity", "2");
    floor.rig.set("ambient.sky", "0.5:0.25:1");
    EXPECT_NEAR(floor.middle("ambient"), stored_albedo(floor) * 0.5f * 2, 1e-3f);
}

TEST(lighting, lights_add_up_and_hdr_is_their_sum)
{
    Floor floor;
    floor.rig.light("sun,direction=0:-1:0,illuminance=3");
    floor.rig.light("point,position=0:2:0,intensity=20,color=0.5:1:1");
    floor.rig.set("ambient.intensity", "1");
    const float sum = floor.middle("light.0") + floor.middle("light.1") + floor.middle("ambient");
    EXPECT_NEAR(floor.middle("hdr"), sum, 2e-3f * sum); // half floats
}

TEST(lighting, exposure_scales_the_picture_and_not_the_aovs)
{
    Floor floor;
    floor.rig.light("sun,direction=0:-1:0,illuminance=10");
    const float before = floor.middle("hdr");
    floor.rig.set("exposure.ev100", "5");
    EXPECT_NEAR(floor.middle("hdr"), before, 2e-3f * before);
    EXPECT_NEAR(floor.middle("light.0"), before, 2e-3f * before);
}

TEST(tonemap, linear_half_is_188_and_one_stop_halves)
{
    Floor floor;
    floor.rig.light("sun,direction=0:-1:0,illuminance=1");
    const float wanted = 0.5f / floor.middle("light.0");
    floor.rig.request.lights.front().illuminance = wanted;
    floor.rig.request.want_picture = true;
    EXPECT_NEAR(*floor.rig.render().picture.at(160, 90), 188, 1);
    floor.rig.set("exposure.ev100", "1");
    EXPECT_NEAR(*floor.rig.render().picture.at(160, 90), 137, 1); // sRGB of 0.25
}

TEST(tonemap, aces_maps_grey_as_its_table_says)
{
    Floor floor;
    floor.rig.light("sun,direction=0:-1:0,illuminance=1");
    floor.rig.set("tonemap.operator", "aces");
    floor.rig.request.want_picture = true;
    const float unit = floor.middle("light.0");
    for (const auto& [in, byte] : {std::pair{0.18f, 91.5f}, std::pair{1.0f, 205.6f}, std::pair{16.0f, 253.9f}}) {
        floor.rig.request.lights.front().illuminance = in / unit;
        EXPECT_NEAR(*floor.rig.render().picture.at(160, 90), byte, 1.1f) << in; // sRGB of 0.10559, 0.61912, 0.98994
    }
}

TEST(lighting, metals_have_no_diffuse_and_a_mirror_shows_its_lobe)
{
    // A rough metal under a light straight above, seen from straight above: f = D V F with all cosines 1.
    BakeData scene = truth::floor_scene();
    Material& m = scene.scene.materials.front();
    m.base_color = vec3(0.8f);
    m.base_color_texture = m.surface_texture = m.normal_texture = no_texture;
    m.metallic = 1;
    m.roughness = 0.5f;
    rig::FrameRig rig(scene);
    rig.look({0, 4, 0}, {0, 0, 0});
    rig.set("ambient.intensity", "0");
    rig.light("sun,direction=0:-1:0,illuminance=10");
    const std::vector<ImageF> got = rig.aovs({"light.0", "albedo", "roughness", "metallic"});
    const double base = *got[1].at(160, 90), r = *got[2].at(160, 90), a2 = std::pow(r, 4);
    EXPECT_NEAR(*got[3].at(160, 90), 1, 1e-6);
    // D(1) = 1 / (pi a2); V = 0.25 at n.l = n.v = 1; Schlick at v.h = 1 gives f0. The pixel is 0.01 m off: |cos - 1| <
    // 1e-5.
    EXPECT_NEAR(*got[0].at(160, 90), 10 * base * 0.25 / (pi * a2), 0.01 * 10 * base * 0.25 / (pi * a2));
}

} // namespace
} // namespace atrium
