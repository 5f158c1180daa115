#pragma once
// All settings: each technique's own struct, under the names users know.

#include "renderer/core/setting.hpp"
#include "renderer/gpu/present_mode.hpp"
#include "renderer/techniques/ao/ao.hpp"
#include "renderer/techniques/aov/aov.hpp"
#include "renderer/techniques/buffer_view/buffer_view.hpp"
#include "renderer/techniques/culling/culling.hpp"
#include "renderer/techniques/gbuffer/gbuffer.hpp"
#include "renderer/techniques/lighting/lighting.hpp"
#include "renderer/techniques/shadow/shadow.hpp"
#include "renderer/techniques/sky/sky.hpp"
#include "renderer/techniques/tonemap/tonemap.hpp"

#include <array>

namespace atrium {

enum class RenderPath : std::uint8_t { deferred };
constexpr auto enum_names(RenderPath)
{
    return std::array{"deferred"};
}

struct RendererSettings {
    RenderPath path = RenderPath::deferred;
};

template <class V>
void describe(V& v, RendererSettings& s)
{
    v.group("renderer", "Renderer");
    v("path", s.path, "How surfaces are shaded");
}

struct CameraSettings {
    float near = 0;
};

template <class V>
void describe(V& v, CameraSettings& s)
{
    v.group("camera", "Camera");
    v("near", s.near, "Near plane; 0: from the scene's size (diagonal / 20000, 1 mm to 0.1 m)", Range{0, 100}, "m");
}

struct ViewSettings {
    float moving_scale = 0;
    gpu::PresentMode vsync = gpu::PresentMode::on;
};

template <class V>
void describe(V& v, ViewSettings& s)
{
    v.group("view", "Window");
    v("moving_scale", s.moving_scale,
      "Share of the window's pixels along each side that are drawn while something moves; 0: as the time of a frame "
      "allows",
      Range{0, 1}, "");
    v("vsync", s.vsync,
      "Frames wait for the display (on), only those that are not late (adaptive), or none does (off); on where the "
      "window offers no other");
}

struct TextureSettings {
    float anisotropy = 8;
};

template <class V>
void describe(V& v, TextureSettings& s)
{
    v.group("texture", "Texture filtering");
    v("anisotropy", s.anisotropy, "Most samples along the longer side of a footprint; 1: trilinear", Range{1, 16},
      "samples", Cpu{1.0f});
}

struct Settings {
    RendererSettings renderer;
    CameraSettings camera;
    ViewSettings view;
    MaterialSettings material;
    TextureSettings texture;
    AmbientSettings ambient;
    AoSettings ao;
    ShadowSettings shadow;
    SkySettings sky;
    ExposureSettings exposure;
    TonemapSettings tonemap;
    CullingSettings culling;
    DebugSettings debug;
    BufferViewSettings buffer_view;
};

template <class V>
void describe(V& v, Settings& s)
{
    describe(v, s.renderer);
    describe(v, s.camera);
    describe(v, s.view);
    describe(v, s.material);
    describe(v, s.texture);
    describe(v, s.ambient);
    describe(v, s.ao);
    describe(v, s.shadow);
    describe(v, s.sky);
    describe(v, s.exposure);
    describe(v, s.tonemap);
    describe(v, s.culling);
    describe(v, s.debug);
    describe(v, s.buffer_view);
}

} // namespace atrium
