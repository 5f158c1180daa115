#pragma once
// Deferred lighting from the G-buffer. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/scene/light.hpp"
#include "renderer/techniques/gbuffer/gbuffer.hpp"
#include "shaders/shared/light.h"

#include <string>

namespace atrium {

struct AmbientSettings {
    vec3 sky{0.55f, 0.70f, 1.0f};
    vec3 ground{0.35f, 0.30f, 0.25f};
    float intensity = 0.8f;
};

template <class V>
void describe(V& v, AmbientSettings& s)
{
    v.group("ambient", "Ambient light");
    v("sky", s.sky, "Radiance from above", Range{0, 1000}, "nit-like");
    v("ground", s.ground, "Radiance from below", Range{0, 1000}, "nit-like");
    v("intensity", s.intensity, "Multiplies both", Range{0, 1000}, "");
}

/// A light as shaders want it: unit direction, cosines instead of angles, colour x strength x exposure.
[[nodiscard]] shared::GpuLight to_gpu(const Light& light, float exposure);

/// What of the light to add up. `scale` undoes the exposure for AOVs.
struct LightingTerms {
    std::uint32_t first_light = 0, end_delta = 0, end_light = 0; ///< places: [first, end_delta), [end_delta, end_light)
    bool ambient = true, emission = true;
    bool multi_bounce = false; ///< ambient light reflected between nearby bright surfaces
    float scale = 1;
    gpu::Format format = gpu::Format::rgba16_float;
    std::string pass = "lighting", target = "hdr";
};

/// Reads  surfaces; `ao`, ambient visibility; `visibility`, a layer for each light with a shadow_layer. Either may be a
/// constant 1 (Graph::constant, constant_array), which is not sampled.  Writes  radiance x exposure (RGBA16F by
/// default, 0 where there is no geometry). Source: the field's standard split; BRDF and falloff: shaders/lib/brdf.glsl,
/// lights.glsl.
[[nodiscard]] graph::Tex add_lighting(graph::Graph& g, const GBuffer& gb, graph::Tex ao, graph::Tex visibility,
                                      const LightingTerms& terms);

} // namespace atrium
