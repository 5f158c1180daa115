#pragma once
// The frame: which techniques, in which order.

#include "renderer/frame_request.hpp"
#include "renderer/gpu_scene.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/scene/light_set.hpp"
#include "renderer/scene/view.hpp"
#include "renderer/techniques/shadow/shadow_maps.hpp"

#include <memory>
#include <span>
#include <vector>

namespace atrium {

/// What a frame is made of; everything a technique may ask for.
struct FrameContext {
    const Settings& settings;
    const GpuScene& scene;
    const View& view;
    const LightSet& lights;
    ShadowMaps* shadow_maps = nullptr;     ///< null: lights cast no shadows
    bool remember = false;                 ///< FrameRequest::remember
    bool can_draw_lines = true;            ///< gpu::OptionalFeatures::lines
    const Insets* insets = nullptr;        ///< null: none
    std::optional<std::uint32_t> outlined; ///< a material
    bool absent_images = false;            ///< AovInputs::absent_images
};

/// A scene turned into radiance, with the intermediate images that AOVs are made from.
struct SceneImages {
    AovInputs aov_inputs;
    graph::Tex hdr; ///< radiance x exposure, sky included
};

/// One way of shading a scene. Renderers can be swapped between frames (`renderer.path`).
class Renderer {
public:
    virtual ~Renderer() = default;
    /// Adds the passes from culling to radiance.
    [[nodiscard]] virtual SceneImages add_passes(graph::Graph& g, const FrameContext& frame) const = 0;
};

[[nodiscard]] std::unique_ptr<Renderer> make_renderer(RenderPath path);

struct ShownBuffer {
    graph::Tex values;     ///< R32F or RGBA32F
    graph::Buf statistics; ///< shared::BufferStatistics
    int channels = 1;      ///< of `values` that mean something
    std::uint32_t mode;    ///< shared::view_…, as it is shown
    bool absent;           ///< AovImage::absent
};

/// A frame's graph and those of its images that were asked for.
struct Frame {
    graph::Tex picture;             ///< RGBA8, sRGB-encoded
    graph::Tex hdr;                 ///< RGBA16F, radiance x exposure
    std::vector<DrawList> draws;    ///< into the G-buffer, one after the other
    std::vector<AovImage> aovs;     ///< as asked, in order
    std::vector<ShownBuffer> shown; ///< the one in place of the picture, if any, then the insets
    GraphImages images;             ///< that can be shown
    std::size_t own_passes = 0;     ///< as many of the first passes make the picture; the others look at images
    graph::Tex insets;              ///< RGBA8, sRGB-encoded, side by side; none: there are none
};

/// The whole frame. Throws Error(usage) when debug.view names no AOV.
[[nodiscard]] Frame build_frame(graph::Graph& g, const Renderer& renderer, const FrameContext& frame,
                                std::span<const Aov> aovs);

} // namespace atrium
