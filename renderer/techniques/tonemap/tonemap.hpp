#pragma once
// Exposure and tone mapping: from scene radiance to a display picture. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"

#include <array>

namespace atrium {

enum class ExposureMode : std::uint8_t { manual };
constexpr auto enum_names(ExposureMode)
{
    return std::array{"manual"};
}

struct ExposureSettings {
    ExposureMode mode = ExposureMode::manual;
    float ev100 = 0;
};

template <class V>
void describe(V& v, ExposureSettings& s)
{
    v.group("exposure", "Exposure");
    v("mode", s.mode, "How the exposure is found");
    v("ev100", s.ev100, "Exposure value at ISO 100: radiance is multiplied by 2^-EV; at 0, 1.0 shows as 1.0",
      Range{-24, 24}, "EV");
}

/// Factor from radiance to what the tone operator gets.
[[nodiscard]] float exposure_scale(const ExposureSettings& s);

/// Values as in shaders/shared/tonemap.h.
enum class ToneOperator : std::uint8_t { linear, aces };
constexpr auto enum_names(ToneOperator)
{
    return std::array{"linear", "aces"};
}

struct TonemapSettings {
    ToneOperator tone_operator = ToneOperator::aces;
};

template <class V>
void describe(V& v, TonemapSettings& s)
{
    v.group("tonemap", "Tone mapping");
    v("operator", s.tone_operator, "How radiance becomes display colour: as it is, or by the fitted ACES curve");
}

/// Reads  radiance x exposure.  Writes  the picture (RGBA8, sRGB-encoded by the target).
/// Source: linear; ACES fit by Stephen Hill 2015.
[[nodiscard]] graph::Tex add_tonemap(graph::Graph& g, graph::Tex hdr, const TonemapSettings& s);

} // namespace atrium
