#pragma once
// Ambient occlusion: how much of the light from all around reaches a pixel. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/scene/view.hpp"

#include <array>
#include <string>

namespace atrium {

enum class AoMethod : std::uint8_t { off, ssao, gtao };
constexpr auto enum_names(AoMethod)
{
    return std::array{"off", "ssao", "gtao"};
}

struct AoSettings {
    AoMethod method = AoMethod::gtao;
    float radius = 0.5f;
    int samples = 18;
    float falloff = 0.2f;
    float power = 1;
    float thin = 0;
    bool multi_bounce = false;
    bool half_resolution = false;
    bool blur = true;
};

template <class V>
void describe(V& v, AoSettings& s)
{
    v.group("ao", "Ambient occlusion");
    v("method", s.method, "Algorithm: hemisphere samples (ssao) or horizon search (gtao)", Keys{"O"});
    v("radius", s.radius, "How far away things still darken", Range{0.01f, 50}, "m");
    v("samples", s.samples, "Depths read at each pixel", Range{2, 128}, "");
    v("falloff", s.falloff, "gtao: share of the radius over which things stop counting; 0: at once", Range{0, 1}, "");
    v("power", s.power, "Exponent of the result; 1: as reckoned", Range{0.1f, 8}, "");
    v("thin", s.thin, "gtao: how thin things are taken to be; 0: endless along the view", Range{0, 4}, "");
    v("multi_bounce", s.multi_bounce, "Let light that bright surfaces give each other into corners");
    v("half_resolution", s.half_resolution, "Compute at half the width and height, then upsample", Cpu{true});
    v("blur", s.blur, "Average the noise of 4 x 4 pixels within a surface");
}

/// Ambient visibility, 0 to 1, in the first channel. Both are Graph::constant(1) if the method is off.
struct AmbientOcclusion {
    graph::Tex raw;    ///< before blur, at full or half size (second channel: distance along the view axis, m)
    graph::Tex result; ///< at full size
};

/// Reads  depth and geometric normals (lib/depth_normal.glsl) at render size. `view` must be the view of the frame's
/// constants. Passes `ao`, `ao.blur`, `ao.upsample`; `prefix` is put before their names and those of their images.
/// Sources: the shaders.
[[nodiscard]] AmbientOcclusion add_ao(graph::Graph& g, graph::Tex depth, graph::Tex normal, const View& view,
                                      const AoSettings& s, const std::string& prefix = "");

} // namespace atrium
