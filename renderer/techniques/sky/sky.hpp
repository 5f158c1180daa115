#pragma once
// A procedural sky behind everything. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/techniques/gbuffer/gbuffer.hpp"

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
      "A floor below the scene that shows its shadows, seen by the picture and hdr alone; auto: where the scene is "
      "seen "
      "from outside and neither camera nor lights were given");
}

/// Where the floor lies.
struct FloorPlace {
    vec3 middle{0};   ///< of the scene, at its lowest point, m, world
    float radius = 1; ///< m around it that the scene takes up: far beyond, the floor fades to the horizon
};
[[nodiscard]] FloorPlace floor_below(const Bounds& scene);

/// The floor as G-buffers, of which depth (R32F; 0: nothing) and normals are its own.
struct FloorSurface {
    FloorPlace place;
    GBuffer visible; ///< where the floor is seen
    GBuffer whole;   ///< and behind what stands before it the scene's depth
    explicit operator bool() const { return static_cast<bool>(visible.depth); }
};
/// Reads  the G-buffer's depth.  Pass `sky.floor`.
[[nodiscard]] FloorSurface add_floor(graph::Graph& g, const GBuffer& gb, const FloorPlace& place);

/// What reaches the floor.
struct FloorLight {
    graph::Tex visibility; ///< a layer for each light with a shadow_layer; none: all are seen
    graph::Tex ao;         ///< what of the ambient light reaches it; none: all of it
    bool rects = true;     ///< there are rectangles among the lights
};

/// Reads  depth.  Draws into `radiance` where depth is that of the far plane: the sky, and the floor where there is
/// one.
void add_sky(graph::Graph& g, graph::Tex depth, graph::Tex radiance, const FloorSurface& floor = {},
             const FloorLight& light = {});

} // namespace atrium
