#include "renderer/techniques/lighting/lighting.hpp"

#include "shaders/shared/lighting.h"

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

/// More would make the shader long, and compiling it slow.
constexpr std::uint32_t max_unrolled_lights = 8;

float strength(const Light& light)
{
    switch (light.type) {
    case LightType::sun:
        return light.illuminance;
    case LightType::rect:
        return light.radiance;
    default:
        return light.intensity;
    }
}

} // namespace

shared::GpuLight to_gpu(const Light& light, float exposure)
{
    shared::GpuLight out{};
    out.shadow_layer = shared::no_shadow_layer;
    out.type = static_cast<std::uint32_t>(light.type);
    out.position = light.position;
    const LightAxes axes = axes_of(light);
    out.direction = axes.direction;
    out.color = light.color * (strength(light) * exposure);
    out.inv_range2 = light.range > 0 ? 1.0f / (light.range * light.range) : 0.0f;
    out.spot_scale = 0;
    out.spot_offset = 1;
    if (light.type == LightType::spot) {
        const float cos_inner = std::cos(glm::radians(light.inner)), cos_outer = std::cos(glm::radians(light.outer));
        out.spot_scale = 1.0f / std::max(cos_inner - cos_outer, 1e-4f);
        out.spot_offset = -cos_outer * out.spot_scale;
    }
    if (light.type == LightType::rect) {
        out.half_right = axes.right * (0.5f * light.width);
        out.half_up = axes.up * (0.5f * light.height);
    }
    out.local = 1;
    if (light.type == LightType::sun) {
        out.local = 0;
        out.position = -out.direction;
    }
    const float sine = std::sin(glm::radians(0.5f * light.angle));
    out.sin2_radius = sine * sine;
    return out;
}

graph::Tex add_lighting(graph::Graph& g, const GBuffer& gb, graph::Tex ao, graph::Tex visibility,
                        const LightingTerms& terms)
{
    graph::TexDesc desc = g.desc(gb.depth);
    desc.format = terms.format;
    const graph::Tex radiance = g.texture(terms.target, desc);

    const std::uint32_t flags = (terms.ambient ? shared::term_ambient : 0u) |
                                (terms.emission ? shared::term_emission : 0u) |
                                (terms.multi_bounce ? shared::term_multi_bounce : 0u);
    const bool unroll = terms.first_light == 0 && terms.end_delta <= max_unrolled_lights;
    const std::uint32_t rects = terms.end_light > terms.end_delta ? 1 : 0;
    const std::uint32_t occluded = g.constant_value(ao) != 1.0f ? 1 : 0;
    const std::uint32_t shadowed = g.constant_value(visibility) != 1.0f ? 1 : 0;
    graph::PassBuilder pass = g.raster(terms.pass);
    reads(pass, gb)
        .reads(ao)
        .reads(visibility)
        .writes(radiance)
        .fullscreen("techniques/lighting/lighting.frag", {unroll ? terms.end_delta : 0, rects, occluded, shadowed},
                    shared::LightingPush{terms.first_light, terms.end_delta, terms.end_light, flags, terms.scale});
    return radiance;
}

} // namespace atrium
