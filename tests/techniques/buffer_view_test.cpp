// Buffers as pictures: statistics, ranges and colours against known answers.

#include "shaders/shared/viridis.h"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace atrium {
namespace {

constexpr float wall_distance = 4;

/// A wall 2 m wide and high that faces the camera, and nothing around it.
BakeData wall()
{
    truth::SceneBuilder builder;
    const std::uint32_t grey = builder.add_material("grey");
    builder.add_mesh("wall", grey, truth::quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
    return builder.finish();
}

/// Red, green and blue of a pixel, as they stand in the file.
vec3 pixel(const Image8& picture, ivec2 at)
{
    const std::uint8_t* p = picture.at(at.x, at.y);
    return {p[0], p[1], p[2]};
}

void expect_color(const Image8& picture, ivec2 at, const vec3& srgb, const char* what)
{
    const vec3 difference = glm::abs(pixel(picture, at) - 255.0f * srgb);
    EXPECT_LE(std::max({difference.x, difference.y, difference.z}), 1.0f) << what; // rounded twice
}

struct Wall : ::testing::Test {
    Wall() : rig(wall())
    {
        rig.look({0, 0, wall_distance}, {0, 0, 0});
        rig.request.want_picture = true;
    }
    const ivec2 middle{160, 90}, corner{2, 2}; ///< on the wall, beside it
    rig::FrameRig rig;
};

using buffer_view_of_a_wall = Wall;

TEST_F(buffer_view_of_a_wall, statistics_leave_the_endless_background_out)
{
    rig.set("debug.view", "depth");
    rig.set("buffer_view.range", "fitted");
    const ImageF depth = rig.aov("depth");
    const BufferFacts facts = rig.render().buffers.at(0);
    const auto wall_pixels =
        std::count_if(depth.values.begin(), depth.values.end(), [](float d) { return std::isfinite(d); });
    EXPECT_EQ(facts.count, static_cast<std::uint32_t>(wall_pixels));
    EXPECT_GT(facts.count, 1000u);
    for (const float value : {facts.low, facts.mean, facts.high}) EXPECT_NEAR(value, wall_distance, 1e-4f);
    EXPECT_GT(facts.range.y, facts.range.x); // also where all values are the same
}

TEST_F(buffer_view_of_a_wall, colours_follow_the_range_that_is_given)
{
    rig.set("debug.view", "depth");
    rig.set("buffer_view.range", "given");
    for (const bool inverted : {false, true}) {
        rig.set("buffer_view.low", inverted ? "16" : "0");
        rig.set("buffer_view.high", inverted ? "0" : "16");
        const float t = inverted ? 0.75f : 0.25f;
        rig.set("buffer_view.colors", "viridis");
        expect_color(rig.render().picture, middle, shared::viridis(t), "viridis");
        rig.set("buffer_view.colors", "grey");
        const float grey = 1.055f * std::pow(t, 1 / 2.4f) - 0.055f; // IEC 61966-2-1
        expect_color(rig.render().picture, middle, vec3(grey), "grey");
        expect_color(rig.render().picture, corner, vec3(inverted ? 0 : 1), "infinity");
    }
}

TEST_F(buffer_view_of_a_wall, one_channel_is_shown_in_grey)
{
    rig.set("debug.view", "normal"); // (0, 0, 1), from -1 to 1
    expect_color(rig.render().picture, middle, {0.7354f, 0.7354f, 1}, "all");
    for (const auto& [channel, grey] : {std::pair{"r", 0.7354f}, std::pair{"g", 0.7354f}, std::pair{"b", 1.0f}}) {
        rig.set("buffer_view.channels", channel);
        expect_color(rig.render().picture, middle, vec3(grey), channel);
    }
}

TEST_F(buffer_view_of_a_wall, an_inset_is_the_full_view_made_small)
{
    rig.set("debug.view", "depth");
    const Aov depth = parse_aov("depth", {});
    BufferViewSettings look;
    look.range = BufferRange::given;
    look.high = 8;
    rig.request.insets = {{{depth, {}}, {depth, look}}, {32, 18}};
    const FrameResult frame = rig.render();
    ASSERT_EQ(frame.buffers.size(), 3u);
    EXPECT_EQ(frame.buffers[0].range, frame.buffers[1].range);
    EXPECT_EQ(frame.buffers[2].range, vec2(0, 8)); // each in its own way
    for (const BufferFacts& facts : frame.buffers) EXPECT_EQ(facts.count, frame.buffers[0].count);
}

/// Every buffer, under validation, at a size that no tile divides.
TEST(buffer_view, statistics_of_every_buffer_are_those_of_its_values)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.light("sun,direction=-0.3:-1:-0.2,name=sun");
    rig.light("spot,position=0:4:0,intensity=200,inner=20,outer=35,name=spot");
    rig.set("ao.method", "gtao");
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    rig.request.size = {161, 91};
    rig.request.keep_picture = PictureSlot::main;
    rig.request.keep_buffers = true;
    int with_values = 0;
    for (const std::string& name : aov_names(rig.request.lights)) {
        const Aov aov = parse_aov(name, rig.request.lights);
        rig.request.insets = {{{aov, {}}}, {40, 23}};
        rig.request.aovs = {aov};
        const FrameResult frame = rig.render();
        const ImageF& values = frame.aovs.at(0);
        float low = std::numeric_limits<float>::infinity(), high = -low;
        double sum = 0;
        std::uint32_t count = 0;
        for (const float v : values.values) {
            if (!std::isfinite(v)) continue;
            low = std::min(low, v);
            high = std::max(high, v);
            sum += v;
            ++count;
        }
        const BufferFacts& facts = frame.buffers.at(0);
        EXPECT_EQ(facts.count, count) << name;
        for (const ivec2 at : {ivec2(0, 0), ivec2(80, 45), ivec2(values.width - 1, values.height - 1)}) {
            const vec2 point = (vec2(at) + 0.5f) / vec2(values.width, values.height);
            const std::vector<float> under = rig::engine().buffer_value(0, point);
            ASSERT_EQ(under.size(), static_cast<std::size_t>(values.channels)) << name;
            for (std::size_t c = 0; c < under.size(); ++c) {
                EXPECT_EQ(under[c], values.at(at.x, at.y)[c]) << name; // to the bit: what --aov writes
            }
        }
        if (count == 0) continue;
        ++with_values;
        EXPECT_EQ(facts.low, low) << name;
        EXPECT_EQ(facts.high, high) << name;
        const double largest = std::max(std::abs(low), std::abs(high));
        EXPECT_NEAR(facts.mean, sum / count, 1e-5 * largest) << name;
    }
    EXPECT_GE(with_values, 30);
}

TEST(buffer_view, keeps_no_values_unless_asked)
{
    rig::FrameRig rig(wall());
    rig.set("debug.view", "depth");
    rig.request.keep_picture = PictureSlot::main;
    static_cast<void>(rig.render());
    EXPECT_TRUE(rig::engine().buffer_value(0, vec2(0.5f)).empty());
    rig.request.keep_buffers = true;
    static_cast<void>(rig.render());
    EXPECT_EQ(rig::engine().buffer_value(0, vec2(0.5f)).size(), 1u);
    EXPECT_TRUE(rig::engine().buffer_value(1, vec2(0.5f)).empty());
}

TEST(buffer_view, viridis_is_the_published_one)
{
    // Rows 0, 8, 128, 240 and 255 of the 256 that were published, between and on those that we have.
    const std::pair<float, vec3> published[]{{0, {0.267004f, 0.004874f, 0.329415f}},
                                             {8, {0.277018f, 0.050344f, 0.375715f}},
                                             {128, {0.127568f, 0.566949f, 0.550556f}},
                                             {240, {0.845561f, 0.887322f, 0.099702f}},
                                             {255, {0.993248f, 0.906157f, 0.143936f}}};
    for (const auto& [row, color] : published) {
        const vec3 difference = glm::abs(shared::viridis(row / 255) - color);
        EXPECT_LE(std::max({difference.x, difference.y, difference.z}), 0.005f) << row;
    }
}

} // namespace
} // namespace atrium
