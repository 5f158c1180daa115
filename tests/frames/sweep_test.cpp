// Every value of every setting, every AOV and odd sizes, in one run under validation (rig: one message fails the
// program).

#include "tests/rig/frame_rig.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace atrium {
namespace {

/// All values of an enum or a switch; ends and middle of a range.
std::vector<std::string> values_of(const Setting& s)
{
    const std::string type = s.type();
    if (type == "bool") return {"on", "off"};
    if (type == "enum") return s.values;
    if (s.key == "debug.view") {
        std::vector<std::string> names;
        for (const AovInfo& info : aov_table())
            names.push_back(info.per_light ? std::string(info.name) + ".1" : info.name);
        names.emplace_back("");
        return names;
    }
    if (!s.range) return {};
    std::vector<std::string> out;
    for (const float v : {s.range->min, 0.5f * (s.range->min + s.range->max), s.range->max}) {
        const std::string text = type == "int" ? std::to_string(std::lround(v)) : std::to_string(v);
        out.push_back(type == "vec3" ? text + ":" + text + ":" + text : text);
    }
    return out;
}

void light_all_kinds(rig::FrameRig& rig)
{
    rig.light("sun,direction=-0.3:-1:-0.2");
    rig.light("spot,position=0:4:0,intensity=200,inner=20,outer=35");
    rig.light("point,position=1:2:1,intensity=50,range=8");
    rig.light("rect,position=0:5:0,direction=0:-1:0,up=1:0:0,width=2,height=1");
}

void expect_finite(const FrameResult& frame, const std::string& what)
{
    for (const float v : frame.hdr.values) ASSERT_TRUE(std::isfinite(v)) << what;
}

TEST(sweep, every_value_of_every_setting_draws)
{
    rig::FrameRig rig(rig::courtyard_bake());
    light_all_kinds(rig);
    rig.request.size = {64, 36};
    rig.request.want_picture = rig.request.want_hdr = true;
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    rig.set("shadow.reference_points", "3");
    Settings described;
    SettingList list;
    describe(list, described);
    std::size_t drawn = 0;
    for (const Setting& s : list.all()) {
        const std::string before = s.get();
        for (const std::string& value : values_of(s)) {
            rig.set(s.key, value);
            expect_finite(rig.render(), s.key + "=" + value);
            ++drawn;
        }
        rig.set(s.key, before);
    }
    EXPECT_GT(drawn, 40u);
}

TEST(sweep, every_aov_at_once_and_alone)
{
    rig::FrameRig rig(rig::courtyard_bake());
    light_all_kinds(rig);
    rig.request.size = {64, 36};
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    std::vector<std::string> names;
    for (const AovInfo& info : aov_table()) {
        for (int light = 0; light < (info.per_light ? 4 : 1); ++light) {
            names.push_back(info.per_light ? std::string(info.name) + "." + std::to_string(light) : info.name);
        }
    }
    const std::vector<ImageF> together = rig.aovs(names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(rig.aov(names[i]).values, together[i].values) << names[i];
    }
}

TEST(sweep, sizes_even_odd_and_tiny)
{
    rig::FrameRig rig(rig::courtyard_bake());
    light_all_kinds(rig);
    rig.request.want_picture = rig.request.want_hdr = true;
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    for (const uvec2 size : {uvec2(1, 1), uvec2(3, 2), uvec2(320, 180), uvec2(1280, 720), uvec2(1919, 1081)}) {
        rig.request.size = size;
        const FrameResult frame = rig.render();
        EXPECT_EQ(frame.picture.width, static_cast<int>(size.x));
        EXPECT_EQ(frame.picture.height, static_cast<int>(size.y));
        expect_finite(frame, std::to_string(size.x));
    }
}

TEST(sweep, no_lights_and_as_many_as_there_may_be)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.request.size = {64, 36};
    rig.request.want_hdr = true;
    rig.look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    expect_finite(rig.render(), "none");
    for (int i = 0; i < max_lights; ++i)
        rig.light("point,position=" + std::to_string(i % 8 - 4) + ":2:" + std::to_string(i / 8 - 4) +
                  ",intensity=2,range=5");
    expect_finite(rig.render(), "64");
}

} // namespace
} // namespace atrium
