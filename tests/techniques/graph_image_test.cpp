// Images of the frame graph by their names, against AOVs that hold the same.

#include "renderer/core/error.hpp"
#include "tests/rig/frame_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

struct Courtyard : ::testing::Test {
    Courtyard() : rig(rig::courtyard_bake())
    {
        rig.light("sun,direction=-0.3:-1:-0.2,name=sun");
        rig.light("spot,position=0:4:0,intensity=200,inner=20,outer=35,name=spot");
        rig.set("ao.method", "gtao");
        rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    }
    rig::FrameRig rig;
};

using graph_image = Courtyard;

TEST_F(graph_image, of_the_g_buffer_is_what_aovs_unpack)
{
    const std::vector<ImageF> got =
        rig.aovs({"graph.gbuffer.albedo", "albedo", "metallic", "graph.gbuffer.id", "instance", "graph.gbuffer.depth",
                  "depth", "graph.gbuffer.motion", "motion", "graph.gbuffer.normal"});
    ASSERT_EQ(got[0].channels, 4);
    ASSERT_EQ(got[7].channels, 2);
    EXPECT_EQ(got[9].channels, 2);
    const float near = default_near(rig.bake().scene().bounds);
    int surface = 0;
    for (int y = 0; y < got[0].height; ++y) {
        for (int x = 0; x < got[0].width; ++x) {
            const bool background = *got[4].at(x, y) < 0;
            EXPECT_EQ(*got[3].at(x, y) < 256, background); // the id of no record
            if (background) continue;
            ++surface;
            for (int c = 0; c < 3; ++c) ASSERT_EQ(got[0].at(x, y)[c], got[1].at(x, y)[c]);
            ASSERT_EQ(got[0].at(x, y)[3], *got[2].at(x, y));
            for (int c = 0; c < 2; ++c) ASSERT_EQ(got[7].at(x, y)[c], got[8].at(x, y)[c]);
            ASSERT_NEAR(near / *got[5].at(x, y), *got[6].at(x, y), 1e-5f * *got[6].at(x, y)); // divided elsewhere
        }
    }
    EXPECT_GT(surface, 10'000);
}

TEST_F(graph_image, before_exposure_and_after_differ_by_it)
{
    rig.set("exposure.ev100", "2");
    const std::vector<ImageF> got = rig.aovs({"graph.hdr", "hdr"});
    float brightest = 0;
    for (std::size_t pixel = 0; pixel < got[1].values.size() / 3; ++pixel) {
        const float exposed = got[0].values[4 * pixel], plain = got[1].values[3 * pixel];
        ASSERT_NEAR(exposed, exposure_scale(rig.request.settings.exposure) * plain, 1e-5f * plain);
        brightest = std::max(brightest, plain);
    }
    EXPECT_GT(brightest, 0.1f);
}

TEST_F(graph_image, of_a_light_is_a_layer_or_a_map_of_its_own)
{
    rig.set("shadow.resolution", "256");
    const std::vector<ImageF> got = rig.aovs({"graph.visibility", "visibility.sun", "graph.visibility:1",
                                              "visibility.spot", "graph.shadow.0", "shadow_map.sun"});
    EXPECT_EQ(got[0].values, got[1].values);
    EXPECT_EQ(got[2].values, got[3].values);
    EXPECT_NE(got[0].values, got[2].values);
    ASSERT_EQ(got[4].height, 256);
    std::size_t nothing = 0;
    for (std::size_t i = 0; i < got[4].values.size(); ++i) { // nothing casts where depth is 0
        EXPECT_EQ(got[4].values[i] == 0, std::isinf(got[5].values[i]));
        nothing += got[4].values[i] == 0;
    }
    EXPECT_GT(nothing, 0u);
    EXPECT_LT(nothing, got[4].values.size());
}

TEST_F(graph_image, that_is_asked_for_stays_what_it_is_to_the_end)
{
    // Those of the G-buffer hold nothing in the background, save these two.
    const std::string names[]{"gbuffer.id", "gbuffer.depth", "ao.raw", "ao.blurred", "hdr", "picture", "shadow.0"};
    std::vector<std::string> all;
    for (const std::string& name : names) all.push_back("graph." + name);
    rig.request.want_picture = true;
    const Image8 before = rig.render().picture;
    FrameRequest with = rig.request;
    for (const std::string& name : all) with.aovs.push_back(parse_aov(name, with.lights));
    const FrameResult together = rig::engine().render(with);
    EXPECT_EQ(together.picture.values, before.values);
    for (std::size_t i = 0; i < all.size(); ++i) // alone it could share its memory with others
        EXPECT_EQ(rig.aov(all[i]).values, together.aovs[i].values) << all[i];
}

TEST_F(graph_image, that_a_frame_has_not_is_refused_or_in_a_window_shown_as_nothing)
{
    rig.set("ao.method", "off");
    for (const char* name :
         {"graph.ao.raw", "graph.hdr:1", "graph.", "graph.readback.picture", "graph.hdr:9999999999"}) {
        try {
            static_cast<void>(rig.aov(name));
            FAIL() << name;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ExitCode::usage);
            EXPECT_NE(e.text().find(name), std::string::npos) << e.text();
        }
    }
    rig.set("debug.view", "graph.ao.raw");
    EXPECT_THROW(static_cast<void>(rig.render()), Error);
    rig.request.keep_picture = PictureSlot::main;
    rig.request.insets = {{{parse_aov("graph.hdr", {}), {}}}, {32, 18}};
    const FrameResult frame = rig.render();
    EXPECT_TRUE(frame.buffers.at(0).absent);
    EXPECT_EQ(frame.buffers.at(0).count, 0u);
    EXPECT_FALSE(frame.buffers.at(1).absent);
    EXPECT_GT(frame.buffers.at(1).count, 0u);
}

TEST_F(graph_image, shows_its_fourth_channel_too)
{
    rig.set("debug.view", "graph.gbuffer.albedo");
    rig.set("buffer_view.channels", "a");
    rig.set("buffer_view.range", "fitted");
    const BufferFacts facts = rig.render().buffers.at(0);
    const ImageF image = rig.aov("graph.gbuffer.albedo");
    float high = 0;
    for (std::size_t i = 3; i < image.values.size(); i += 4) high = std::max(high, image.values[i]);
    EXPECT_EQ(facts.high, high);
    rig.set("debug.view", "depth"); // which has none
    EXPECT_EQ(rig.render().buffers.at(0).high, 0);
}

} // namespace
} // namespace atrium
