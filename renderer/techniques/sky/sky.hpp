#pragma once
// A procedural sky behind everything. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"

namespace atrium {

struct SkySettings {
    vec3 zenith{0.30f, 0.55f, 1.05f};
    vec3 horizon{1.05f, 1.20f, 1.35f};
    vec3 ground{0.35f, 0.32f, 0.28f};
    float intensity = 1.0f;
};

template <class V>
void describe(V& v, SkySettings& s)
{
    v.group("sky", "Sky");
    v("zenith", s.zenith, "Radiance straight up", Range{0, 1000}, "nit-like");
    v("horizon", s.horizon, "Radiance at the horizon", Range{0, 1000}, "nit-like");
    v("ground", s.ground, "Radiance below the horizon", Range{0, 1000}, "nit-like");
    v("intensity", s.intensity, "Multiplies all three", Range{0, 1000}, "");
}

/// Reads  depth.  Draws into `radiance` where depth is that of the far plane.
void add_sky(graph::Graph& g, graph::Tex depth, graph::Tex radiance);

} // namespace atrium
