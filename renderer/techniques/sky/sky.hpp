#pragma once
// A procedural sky behind everything. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/scene/scene.hpp"

#include <array>

namespace atrium {

enum class SkyFloor : std::uint8_t { automatic, on, off };
constexpr auto enum_names(SkyFloor)
{
    return std::array{"auto", "on", "off"};
}

struct SkySettings {
    vec3 zenith{0.30f, 0.55f, 1.05f};
    vec3 horizon{1.05f, 1.20f, 1.35f};
    vec3 ground{0.35f, 0.32f, 0.28f};
    float intensity = 1.0f;
    SkyFloor floor = SkyFloor::automatic;
};

template <class V>
void describe(V& v, SkySettings& s)
{
    v.group("sky", "Sky");
    v("zenith", s.zenith, "Radiance straight up", Range{0, 1000}, "nit-like");
    v("horizon", s.horizon, "Radiance at the horizon", Range{0, 1000}, "nit-like");
    v("ground", s.ground, "Radiance below the horizon", Range{0, 1000}, "nit-like");
    v("intensity", s.intensity, "Multiplies all three", Range{0, 1000}, "");
    v("floor", s.floor,
      "Floor below the scene that receives its shadows, only in the picture and AOV hdr; auto: on if the scene is seen "
      "from outside and neither camera nor lights were given");
}

/// Where the floor lies.
struct FloorPlace {
    vec3 middle{0};   ///< of the scene, at its lowest point, m, world
    float radius = 1; ///< of the scene, m: at several times this distance the floor fades to the horizon
};
[[nodiscard]] FloorPlace floor_below(const Bounds& scene);

/// The floor as depth (R32F, reversed; 0: nothing) and normals, as techniques read them (lib/depth_normal.glsl).
struct FloorSurface {
    FloorPlace place;
    graph::Tex visible_depth; ///< where the floor is seen
    graph::Tex whole_depth;   ///< depth of floor and scene together
    graph::Tex normal;
    explicit operator bool() const { return static_cast<bool>(visible_depth); }
};
/// Reads  the scene's depth.  Pass `sky.floor`.
[[nodiscard]] FloorSurface add_floor(graph::Graph& g, graph::Tex depth, const FloorPlace& place);

/// Visibility of the lights from the floor, and its ambient occlusion. Graph::constant(1): nothing is hidden.
struct FloorLight {
    graph::Tex visibility; ///< a layer for each light with a shadow_layer
    graph::Tex ao;         ///< ambient visibility
    bool rects = true;     ///< there are rectangles among the lights
};

/// Reads  depth, radiance of the scene.  Returns  radiance with the sky where there is no geometry. It is drawn into
/// the same image: use the returned handle from then on.
[[nodiscard]] graph::Tex add_sky(graph::Graph& g, graph::Tex depth, graph::Tex radiance);
/// The same, with the floor in front of the sky.
[[nodiscard]] graph::Tex add_sky_and_floor(graph::Graph& g, graph::Tex depth, graph::Tex radiance,
                                           const FloorSurface& floor, const FloorLight& light);

} // namespace atrium
