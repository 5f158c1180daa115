// A setting changes the outputs that it should change, and no others.

#include "tests/frames/setting_effects.hpp"

#include "renderer/scene/material_override.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace atrium {
namespace {

using effects::Effect;
using effects::Place;
using Outputs = std::map<std::string, std::vector<float>>; ///< values by name of the output

/// A box and a plate on a floor of 20 m, each of one colour.
BakeData open_scene()
{
    truth::SceneBuilder builder;
    builder.add_mesh("floor", builder.add_material("grey"), truth::ground(10));
    builder.add_mesh("box", builder.add_material("red", {0.7f, 0.2f, 0.1f}), truth::box({-1, 0, -1}, {0, 1, 0}));
    builder.add_mesh("plate", builder.add_material("white"), truth::box({0.5f, 1.5f, -1}, {2, 1.6f, 0.5f}));
    return builder.finish();
}

/// A mask of sixteen texels, repeated: at this size a pixel is wider than the mask.
BakeData masked_scene()
{
    const std::vector<std::uint8_t> alpha{255, 0, 255, 255, 0, 255, 0, 255, 255, 255, 0, 0, 0, 255, 255, 255};
    return truth::masked_scene(4, 4, alpha, false, 60);
}

std::unique_ptr<rig::FrameRig> make_rig(Place place)
{
    std::unique_ptr<rig::FrameRig> rig;
    if (place == Place::court) {
        rig = std::make_unique<rig::FrameRig>(rig::courtyard_bake());
        rig->look({-8, 1.7f, 0.5f}, {8, 2.5f, 0});
    } else if (place == Place::open) {
        rig = std::make_unique<rig::FrameRig>(open_scene());
        rig->look({3, 2.5f, 4}, {0, 2, 0}, 70);
    } else {
        rig = std::make_unique<rig::FrameRig>(masked_scene());
        rig->look({0.3f, 0.2f, 3}, {0, 0, 0}, 50);
    }
    rig->light("sun,name=sun,direction=-0.3:-1:-0.2,illuminance=3");
    rig->light("spot,name=spot,position=0:4:0,intensity=60,inner=20,outer=60,size=0.2");
    rig->light("point,name=point,position=1:2:1,intensity=10,range=8,size=0.1");
    rig->light("rect,name=rect,position=0:5:0,direction=0:-1:0,up=1:0:0,width=2,height=1,radiance=4");
    rig->request.size = {96, 54};
    rig->request.want_picture = rig->request.want_statistics = true;
    for (const std::string& name : aov_names(rig->request.lights))
        rig->request.aovs.push_back(parse_aov(name, rig->request.lights));
    for (const auto& [key, value] : effects::common_base()) rig->set(key, value);
    return rig;
}

Outputs draw(const rig::FrameRig& rig)
{
    const FrameResult frame = rig.render();
    Outputs out;
    for (std::size_t i = 0; i < rig.request.aovs.size(); ++i)
        out[aov_name(rig.request.aovs[i], rig.request.lights)] = frame.aovs[i].values;
    out["picture"].assign(frame.picture.values.begin(), frame.picture.values.end());
    out["triangles"] = {static_cast<float>(frame.triangles)};
    return out;
}

bool matches_any(const std::string& name, const std::vector<const char*>& patterns)
{
    return std::any_of(patterns.begin(), patterns.end(), [&](const char* p) { return matches_pattern(p, name); });
}

/// Names of the outputs that differ.
std::set<std::string> changed(const Outputs& before, const Outputs& after)
{
    std::set<std::string> out;
    for (const auto& [name, values] : before)
        if (values != after.at(name)) out.insert(name);
    return out;
}

/// The outputs that an effect changes; the rig's settings are restored. `last`: set after the base.
std::set<std::string> changes_of(rig::FrameRig& rig, const Effect& effect,
                                 std::pair<const char*, const char*> last = {nullptr, nullptr})
{
    const Settings before = rig.request.settings;
    for (const auto& [key, value] : effect.base) rig.set(key, value);
    if (last.first) rig.set(last.first, last.second);
    const Outputs without = draw(rig);
    const Settings unchanged = rig.request.settings;
    rig.set(effect.key, effect.value);
    EXPECT_FALSE(same_settings(unchanged, rig.request.settings)) << effect.key << " has this value already";
    const Outputs with = draw(rig);
    rig.request.settings = before;
    return changed(without, with);
}

std::string title(const Effect& effect)
{
    std::string text = std::string(effect.key) + " = " + effect.value;
    for (const auto& [key, value] : effect.base) text += std::string(", ") + key + " = " + value;
    return text;
}

TEST(setting_effects, every_setting_changes_what_it_should_and_nothing_else)
{
    std::size_t checked = 0;
    for (const Place place : {Place::court, Place::open, Place::masked}) {
        const auto rig = make_rig(place);
        for (const Effect& effect : effects::table()) {
            if (effect.place != place) continue;
            ++checked;
            const std::set<std::string> got = changes_of(*rig, effect);
            for (const char* name : effect.changes)
                EXPECT_TRUE(got.contains(name)) << title(effect) << " does not change " << name;
            for (const std::string& name : got) {
                EXPECT_TRUE(matches_any(name, effect.changes) || matches_any(name, effect.may_change))
                    << title(effect) << " changes " << name;
            }
        }
    }
    EXPECT_EQ(checked, effects::table().size());
}

TEST(setting_effects, every_setting_has_a_row_and_every_row_a_setting)
{
    Settings described;
    SettingList list;
    describe(list, described);
    std::set<std::string> rows;
    for (const Effect& effect : effects::table()) {
        rows.insert(effect.key);
        EXPECT_NE(list.find(effect.key), nullptr) << effect.key << " is no setting";
    }
    ASSERT_GT(list.all().size(), 40u);
    for (const Setting& s : list.all()) {
        if (s.values.size() == 1) continue; // a choice of one value, which cannot be changed
        EXPECT_TRUE(rows.contains(s.key)) << s.key << " needs a row in tests/frames/setting_effects.cpp";
    }
}

TEST(setting_effects, a_row_s_names_are_those_of_outputs)
{
    const auto rig = make_rig(Place::open);
    const Outputs outputs = draw(*rig);
    ASSERT_GT(outputs.size(), 40u);
    for (const Effect& effect : effects::table()) {
        for (const auto& names : {effect.changes, effect.may_change}) {
            for (const char* pattern : names) {
                EXPECT_TRUE(std::any_of(outputs.begin(), outputs.end(),
                                        [&](const auto& o) { return matches_pattern(pattern, o.first); }))
                    << effect.key << ": " << pattern;
            }
        }
    }
}

TEST(setting_effects, what_belongs_to_a_technique_that_is_off_changes_nothing)
{
    const std::array<std::pair<const char*, const char*>, 3> off{
        {{"ao.method", "off"}, {"shadow.filter", "off"}, {"debug.view", ""}}};
    const std::array<const char*, 3> prefixes{"ao.", "shadow.", "buffer_view."};
    const auto rig = make_rig(Place::court);
    std::array<std::set<std::string>, 3> tried;
    for (const Effect& effect : effects::table()) {
        for (std::size_t i = 0; i < off.size(); ++i) {
            const std::string key = effect.key;
            if (!key.starts_with(prefixes[i]) || key == off[i].first || !tried[i].insert(key).second) continue;
            EXPECT_EQ(changes_of(*rig, effect, off[i]), std::set<std::string>()) << title(effect);
        }
    }
    EXPECT_GE(tried[0].size(), 8u);
    EXPECT_GE(tried[1].size(), 14u);
    EXPECT_EQ(tried[2].size(), 5u);
}

} // namespace
} // namespace atrium
