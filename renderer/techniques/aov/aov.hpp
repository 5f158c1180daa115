#pragma once
// AOVs (arbitrary output variables): every intermediate value as an image of 32-bit floats. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/scene/light.hpp"
#include "renderer/techniques/culling/culling.hpp"
#include "renderer/techniques/gbuffer/gbuffer.hpp"
#include "renderer/techniques/lighting/lighting.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace atrium {

struct DebugSettings {
    std::string view;
    bool wireframe = false;
    bool alpha_lod0 = false;
};

template <class V>
void describe(V& v, DebugSettings& s)
{
    v.group("debug", "Debugging");
    v("view", s.view, "Show an AOV in place of the picture (its name; empty: the picture)");
    v("wireframe", s.wireframe, "Draw the edges of triangles over the picture");
    v("alpha_lod0", s.alpha_lod0, "Test masks at mip 0, to compare with ray tracing");
}

enum class AovSource : std::uint8_t {
    gbuffer,          ///< unpacked from the G-buffer; `kind` says what
    light,            ///< lighting by one light alone
    ambient,          ///< lighting by ambient light alone
    hdr,              ///< radiance before exposure
    overdraw,         ///< fragments that passed the depth test, counted by a pass of its own
    depth_complexity, ///< the same before the depth test
    shadow,           ///< of a light that casts shadows; `kind`: shared::show_…
    ao,               ///< an image of ambient occlusion, where it is on
    constant,         ///< a technique that is off: its background everywhere
};

struct AovInfo {
    const char* name; ///< "light" for "light.L" when per_light
    bool per_light;
    int channels; ///< 1, 2 or 3 of the image's four
    AovSource source;
    std::uint32_t kind;      ///< shared::aov_…
    float background;        ///< where the technique is off
    std::uint32_t view_mode; ///< shared::view_…: how debug.view shows it
    float low, high;         ///< range shown; both 0: up to a scene's size
};

/// An AOV that was asked for: the table's row and, where it has one, the light.
struct Aov {
    const AovInfo* info = nullptr;
    std::uint32_t light = 0;
};

[[nodiscard]] std::span<const AovInfo> aov_table();

/// "depth", "light.key", "visibility.0"… Throws Error(usage) naming the nearest valid AOV or light.
[[nodiscard]] Aov parse_aov(std::string_view name, std::span<const Light> lights);
/// What parse_aov() takes, by the light's name.
[[nodiscard]] std::string aov_name(const Aov& aov, std::span<const Light> lights);
/// All of these names: those of a light once for each.
[[nodiscard]] std::vector<std::string> aov_names(std::span<const Light> lights);

/// What AOVs are made from.
struct AovInputs {
    GBuffer gbuffer;
    graph::Tex hdr;
    graph::Tex ao_raw, ao; ///< ambient occlusion before and after its filters; none: off
    bool multi_bounce = false;
    std::vector<DrawList> draws; ///< one after the other
    DrawList occluders;
    Geometry geometry;
    LightOrder lights;
    graph::Tex visibility; ///< of lights; none: no light casts shadows
    /// Adds an image of a light's shadows, by the user's index and shared::show_…, in a pass of that name; an empty one
    /// where the light casts none.
    std::function<graph::Tex(graph::Graph&, std::uint32_t light, std::uint32_t shown, const std::string& pass)>
        shadow_image;
};

/// Writes the AOV (R32F or RGBA32F; `channels` of them mean something), render size.
[[nodiscard]] graph::Tex add_aov(graph::Graph& g, const Aov& aov, const AovInputs& in, float exposure);

} // namespace atrium
