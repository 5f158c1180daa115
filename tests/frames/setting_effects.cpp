// The table of setting_effects.hpp.

#include "tests/frames/setting_effects.hpp"

#include <array>

namespace atrium::effects {
namespace {

using Names = std::vector<const char*>;

Names operator+(Names a, const Names& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

const Names picture{"picture"};
const Names hdr{"hdr", "picture"};
const Names lit = Names{"light.*"} + hdr;       ///< follows from light that arrives
const Names seen = Names{"visibility.*"} + lit; ///< follows from shadows
const Names looked_up = Names{"blocker.*", "penumbra.*"} + seen;
const Names mapped = Names{"shadow_map.*", "cascade.*"} + looked_up; ///< follows from how far filters look around
const Names shaded = Names{"ambient"} + lit;                         ///< follows from a surface
const Names around{"ao", "ao_raw", "ambient", "hdr", "picture"};     ///< follows from ambient occlusion

/// All that follows from which surface is where.
const Names surface =
    Names{"depth",    "position",    "geometric_normal", "normal",           "albedo",    "roughness",
          "metallic", "specular",    "emission",         "material",         "mesh",      "instance",
          "motion",   "light_count", "overdraw",         "depth_complexity", "cascade.*", "triangles"} +
    looked_up + around;

std::vector<Effect> make_table()
{
    return {
        {"camera.near", "5", {}, {"depth", "material", "picture"}, surface + Names{"shadow_map.sun"}},
        {"view.moving_scale", "0.5", {}, {}, {}}, // of the window's pictures
        {"view.vsync", "off", {}, {}, {}},

        {"normal_mapping", "off", {}, {"normal", "picture"}, Names{"ao", "ao_raw"} + looked_up + shaded},
        {"specular_mapping", "off", {}, {"roughness", "picture"}, Names{"specular", "metallic"} + shaded},
        {"texture.anisotropy", "16", {}, {"albedo", "picture"}, surface + Names{"shadow_map.*"}}, // masks too
        {"texture.anisotropy", "16", {}, {}, {}, Place::open},

        {"ambient.sky", "1:0:0", {}, {"ambient", "picture"}, hdr},
        {"ambient.ground", "1:0:0", {}, {"ambient", "picture"}, hdr},
        {"ambient.intensity", "0.2", {}, {"ambient", "picture"}, hdr},

        {"ao.method", "ssao", {}, {"ao", "ao_raw", "ambient", "picture"}, around},
        {"ao.method", "off", {}, {"ao", "ao_raw", "ambient", "picture"}, around},
        {"ao.radius", "2", {}, {"ao", "ao_raw", "picture"}, around},
        {"ao.samples", "4", {}, {"ao", "ao_raw", "picture"}, around},
        {"ao.falloff", "1", {}, {"ao", "ao_raw", "picture"}, around},
        {"ao.falloff", "1", {{"ao.method", "ssao"}}, {}, {}},
        {"ao.power", "3", {}, {"ao", "picture"}, around},
        {"ao.thin", "4", {}, {"ao", "ao_raw", "picture"}, around},
        {"ao.thin", "4", {{"ao.method", "ssao"}}, {}, {}},
        {"ao.multi_bounce", "on", {}, {"ambient", "picture"}, hdr},
        {"ao.half_resolution", "on", {}, {"ao", "ao_raw", "picture"}, around},
        {"ao.blur", "off", {}, {"ao", "picture"}, around}, // the raw values are noisier where a blur follows

        {"shadow.filter", "hard", {}, {"visibility.sun", "visibility.spot", "picture"}, mapped},
        {"shadow.filter", "pcf", {}, {"visibility.sun", "visibility.spot", "picture"}, mapped},
        {"shadow.filter", "reference", {}, {"visibility.sun", "visibility.spot", "picture"}, mapped},
        {"shadow.filter", "off", {}, {"visibility.sun", "shadow_map.sun", "picture"}, mapped},
        {"shadow.resolution", "64", {}, {"visibility.sun", "shadow_map.sun", "picture"}, mapped},
        {"shadow.samples", "4", {}, {"visibility.spot", "picture"}, seen},
        {"shadow.samples", "4", {{"shadow.filter", "pcf"}}, {"visibility.spot", "picture"}, seen},
        {"shadow.samples", "4", {{"shadow.filter", "hard"}}, {}, {}},
        {"shadow.blocker_samples", "4", {}, {"visibility.spot", "blocker.spot", "picture"}, looked_up},
        {"shadow.blocker_samples", "4", {{"shadow.filter", "pcf"}}, {}, {}},
        {"shadow.blur", "off", {}, {"visibility.spot", "picture"}, seen},
        {"shadow.blur", "off", {{"shadow.filter", "pcf"}}, {}, {}},
        {"shadow.softness", "4", {}, {"visibility.spot", "penumbra.spot", "picture"}, mapped},
        {"shadow.softness", "4", {{"shadow.filter", "pcf"}}, {}, {}},
        {"shadow.radius", "12", {{"shadow.filter", "pcf"}}, {"visibility.spot", "picture"}, Names{"cascade.*"} + seen},
        {"shadow.radius", "12", {}, {}, {}}, // of pcf alone
        {"shadow.bias_normal", "8", {}, {"visibility.spot", "picture"}, looked_up},
        {"shadow.bias_slope", "8", {}, {"visibility.spot", "picture"}, looked_up},
        {"shadow.bias_plane", "off", {}, {"visibility.spot", "picture"}, looked_up},
        {"shadow.cascades",
         "1",
         {},
         {"visibility.sun", "cascade.sun", "shadow_map.sun", "picture"},
         {"light.sun", "hdr", "blocker.sun", "penumbra.sun"}},
        {"shadow.cache", "off", {}, {}, {}},
        {"shadow.max_lights",
         "1",
         {},
         {"visibility.spot", "shadow_map.spot", "picture"},
         {"visibility.point", "visibility.rect", "shadow_map.point", "shadow_map.rect", "blocker.*", "penumbra.*",
          "light.spot", "light.point", "light.rect", "hdr"}},
        {"shadow.budget", "1", {}, {"shadow_map.sun", "visibility.sun", "picture"}, mapped},
        {"shadow.reference_points", "9", {{"shadow.filter", "reference"}}, {"visibility.spot", "picture"}, seen},

        {"sky.zenith", "1:0:0", {}, {"hdr", "picture"}, {}, Place::open},
        {"sky.horizon", "1:0:0", {}, {"hdr", "picture"}, {}, Place::open},
        {"sky.ground", "1:0:0", {}, {"hdr", "picture"}, {}, Place::open},
        {"sky.intensity", "0.3", {}, {"hdr", "picture"}, {}, Place::open},
        {"sky.floor", "on", {}, {"hdr", "picture"}, {}, Place::open},

        {"exposure.ev100", "1", {}, {"picture"}, {}}, // one stop: exact in half floats, so AOVs stay what they are
        {"tonemap.operator", "aces", {}, {"picture"}, {}},

        // What is left out would not have been seen.
        {"culling.frustum", "off", {{"culling.triangles", "off"}}, {"triangles"}, {}},
        {"culling.cone", "off", {{"culling.triangles", "off"}}, {"triangles"}, {"overdraw", "depth_complexity"}},
        {"culling.occlusion", "off", {{"culling.triangles", "off"}}, {"triangles"}, {"overdraw", "depth_complexity"}},
        {"culling.triangles", "off", {}, {"triangles"}, {"overdraw", "depth_complexity"}},

        {"debug.view", "depth", {}, {"picture"}, {}},
        {"debug.wireframe", "on", {}, {"picture"}, {}},
        {"debug.alpha_lod0", "on", {}, {"mesh", "depth", "picture"}, surface + Names{"shadow_map.*"}, Place::masked},
        {"debug.alpha_lod0", "on", {}, {}, {}, Place::open}, // without masks

        {"buffer_view.channels", "r", {{"debug.view", "normal"}}, {"picture"}, {}},
        {"buffer_view.range", "fitted", {{"debug.view", "depth"}}, {"picture"}, {}},
        {"buffer_view.low",
         "5",
         {{"debug.view", "depth"}, {"buffer_view.range", "given"}, {"buffer_view.high", "9"}},
         {"picture"},
         {}},
        {"buffer_view.low", "5", {{"debug.view", "depth"}}, {}, {}}, // of a given range alone
        {"buffer_view.high", "9", {{"debug.view", "depth"}, {"buffer_view.range", "given"}}, {"picture"}, {}},
        {"buffer_view.colors", "viridis", {{"debug.view", "depth"}}, {"picture"}, {}},
    };
}

constexpr std::pair<const char*, const char*> common[]{
    {"ao.method", "gtao"},       {"ao.half_resolution", "off"},    {"ao.samples", "18"},
    {"shadow.filter", "pcss"},   {"shadow.resolution", "256"},     {"shadow.samples", "24"},
    {"shadow.max_lights", "4"},  {"shadow.blocker_samples", "12"}, {"shadow.reference_points", "3"},
    {"culling.triangles", "on"}, {"texture.anisotropy", "1"},      {"tonemap.operator", "linear"}};

} // namespace

std::span<const Effect> table()
{
    static const std::vector<Effect> effects = make_table();
    return effects;
}

std::span<const std::pair<const char*, const char*>> common_base()
{
    return common;
}

} // namespace atrium::effects
