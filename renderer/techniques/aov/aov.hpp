#pragma once
// AOVs (arbitrary output variables): every intermediate value as an image of 32-bit floats. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/scene/light_set.hpp"
#include "renderer/techniques/culling/culling.hpp"
#include "renderer/techniques/gbuffer/gbuffer.hpp"
#include "renderer/techniques/lighting/lighting.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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
    graph,            ///< an image of the frame graph as it is
    constant,         ///< a technique that is off: its background everywhere
};

struct AovInfo {
    const char* name; ///< "light" for "light.L" when per_light
    bool per_light;
    int channels; ///< 1, 2 or 3 of the image's four; 4 of images of the graph
    AovSource source;
    std::uint32_t kind;      ///< shared::aov_…
    float background;        ///< where the technique is off
    std::uint32_t view_mode; ///< shared::view_…: how debug.view shows it
    float low, high;         ///< range shown; both 0: up to a scene's size, of images of the graph fitted
};

/// An AOV that was asked for: the table's row and, where it has one, the light or the image of the graph.
struct Aov {
    const AovInfo* info = nullptr;
    std::uint32_t light = 0;
    std::string image{};
    std::uint32_t layer = 0; ///< of the image
};

[[nodiscard]] std::span<const AovInfo> aov_table();

/// "depth", "light.key", "visibility.0", "graph.hdr"… Throws Error(usage) naming the nearest valid AOV or light. Which
/// images the graph has, only a frame knows.
[[nodiscard]] Aov parse_aov(std::string_view name, std::span<const Light> lights);
/// What parse_aov() takes, by the light's name.
[[nodiscard]] std::string aov_name(const Aov& aov, std::span<const Light> lights);
/// All of these names but those of the graph's images: those of a light once for each.
[[nodiscard]] std::vector<std::string> aov_names(std::span<const Light> lights);

/// By name, in order of declaration.
using GraphImages = std::vector<std::pair<std::string, graph::Tex>>;

/// What AOVs are made from.
struct AovInputs {
    GBuffer gbuffer;
    graph::Tex hdr;
    graph::Tex ao_raw, ao; ///< ambient occlusion before and after its filters
    bool multi_bounce = false;
    std::vector<DrawList> draws; ///< one after the other
    DrawList occluders;
    Geometry geometry;
    LightSet lights;
    graph::Tex visibility; ///< of lights
    /// Adds an image of a light's shadows, by the user's index and shared::show_…, in a pass of that name; an empty one
    /// where the light casts none.
    std::function<graph::Tex(graph::Graph&, std::uint32_t light, std::uint32_t shown, const std::string& pass)>
        shadow_image;
    GraphImages images;         ///< of the graph before any AOV
    bool absent_images = false; ///< one that is not there is an AOV that holds nothing; else it is refused
};

/// An AOV of a frame.
struct AovImage {
    graph::Tex values;             ///< R32F or RGBA32F
    const AovInfo* info = nullptr; ///< what it holds; of an image of the graph, by its format
    bool absent = false;           ///< there is no such image, and every value is infinite
};

/// Writes the AOV, of render size unless it has its own. Throws Error(usage) of an image that the graph has not.
[[nodiscard]] AovImage add_aov(graph::Graph& g, const Aov& aov, const AovInputs& in, float exposure);

} // namespace atrium
